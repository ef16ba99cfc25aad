// Times and bytes of passes by the names of their kernels.
#include "sim/gpu/passes/timed_passes.h"

#include <catch2/catch.hpp>

#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("the runs of a kernel are added, with the bytes of their buffers", "[gpu]") {
  Gpu gpu;
  const gl::Buffer few("few", 16), many("many", 1600);
  const gl::ComputePass::Constants zeros{{"word_0", 0}, {"word_1", 0}, {"word_2", 0}, {"word_3", 0}};
  const gl::Program& fill = gpu.programs.compute("common/fill.comp");
  const gl::ComputePass one(fill, {{"filled", &few}}, 1, zeros), hundred(fill, {{"filled", &many}}, 100, zeros);
  CHECK(TimedPasses().kernels().empty());
  TimedPasses timed;
  for (const gl::ComputePass* pass : {&one, &hundred, &one}) {
    pass->run();
    timed.ran(*pass);
  }
  const std::map<std::string, KernelTime> kernels = timed.kernels();
  REQUIRE(kernels.size() == 1);
  CHECK(kernels.begin()->first == fill.label());
  CHECK(kernels.begin()->second.runs == 3);
  CHECK(kernels.begin()->second.bytes == 16 + 1600 + 16);
  CHECK(kernels.begin()->second.ms > 0);
}
