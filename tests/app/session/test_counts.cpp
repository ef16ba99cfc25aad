// Counted costs of the shipped scenes: a scene pays only for the features that it uses, and a change that makes one
// more expensive is detected here.
// Covers: graphics, sim/gpu/solver_counts
#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "gl/buffer.h"
#include "gl/compute_pass.h"
#include "sim/simulation/simulation.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

struct Counts {
  std::string scene;
  std::uint32_t tets_solved;
  std::uint64_t dispatches_per_step;
  std::size_t kernels, gpu_bytes;
};

}  // namespace

TEST_CASE("counts of the shipped scenes", "[counts]") {
  const Counts expected = GENERATE(values<Counts>({{"beam", 4896, 5, 10, 1'780'592},
                                                   {"cube", 500, 5, 9, 212'824},
                                                   {"inclusion", 5585, 5, 10, 2'080'184},
                                                   {"ligament", 7006, 5, 10, 2'512'032},
                                                   {"liver", 9389, 5, 10, 3'358'436}}));
  CAPTURE(expected.scene);
  Graphics graphics = open_graphics(headless(), false);
  Simulation simulation(open_scene(source_dir() / "assets/scenes" / (expected.scene + ".json")),
                        graphics.programs.get(), false);
  const std::uint64_t before = gl::dispatch_count();
  simulation.gpu()->step();
  CHECK(simulation.gpu()->buffers().tet_count == expected.tets_solved);
  CHECK(simulation.gpu()->dispatches_per_step() == expected.dispatches_per_step);
  // In addition to the step's own: the largest compression of all tets, for the law squared, and the regions' speeds,
  // if there are regions.
  const std::uint64_t measured = simulation.gpu()->buffers().tet_count >= RestingRegions::kLeastTets ? 2 : 1;
  CHECK(gl::dispatch_count() - before >=
        expected.dispatches_per_step + measured);            // more if the loops of one dispatch do not suffice
  CHECK(simulation.programs()->size() == expected.kernels);  // including the one that tests the device
  CHECK(gl::allocated_bytes() == expected.gpu_bytes);
  const auto& buffers = gl::bytes_by_buffer();
  const bool several_materials = simulation.model.materials.size() > 1;
  const bool damped = std::any_of(simulation.model.materials.begin(), simulation.model.materials.end(),
                                  [](const Material& m) { return m.damping > 0; });
  CHECK(buffers.contains("tet_material") == several_materials);
  CHECK(buffers.contains("previous_strain") == damped);
  CHECK_FALSE(buffers.contains("displacement_low"));
  CHECK_FALSE(buffers.contains("multiplier"));
}

TEST_CASE("dispatches of a step by storage blocks, as on graphics cards", "[counts]") {
  const Graphics graphics = open_graphics(headless(), false);
  gl::ProgramCache programs(graphics.data_dir / "shaders", gl::LoadPath::storage, gl::Sums::in_groups);
  const auto dispatches = [&](const std::string& scene, const std::vector<std::string>& settings) {
    Simulation simulation(open_scene(source_dir() / "assets/scenes" / (scene + ".json"), settings), &programs, false);
    simulation.gpu()->step();
    return simulation.gpu()->dispatches_per_step();
  };
  // 6 of each of ten iterations, and 12 before and after them: sums end in the dispatches that add their terms, and the
  // gradient after a step applies it.
  CHECK(dispatches("liver", {}) == 72);
  CHECK(dispatches("liver", {"solver.iterations=4"}) == 72 - 6 * 6);
  CHECK(dispatches("liver", {"elements=quadratic"}) == 73);
  CHECK(dispatches("liver", {"solver.acceleration=none"}) == 72);
  // Contact looks at the new state before the gradient: 12 of each iteration, and 23 before and after them.
  CHECK(dispatches("retractor", {}) == 142);
}
