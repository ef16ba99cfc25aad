// A step with fused passes computes the same to the bit as one with separate dispatches. Also run with several of
// llvmpipe's threads (tests.cmake).
#include <catch2/catch.hpp>

#include "gl/fused_pass.h"
#include "sim/gpu/solver.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

// Falls so far in a step that many tets are inverted during the iterations.
Model crushed(int cells, double damping) {
  const double length = 0.1 * cells;
  Model model = make_model(make_box(cells, 4, 4, {length, 0.1, 0.1}),
                           {2e4, 0.4, 1000, damping, MaterialModel::signed_st_venant_kirchhoff},
                           [](const Vector3d& x) { return x.x() < 1e-9; });
  model.gravity = {-300, 0, -50};
  return model;
}

struct Compared {
  Gpu gpu;
  gl::ProgramCache fusing{source_dir() / "shaders", gl::LoadPath::texel};
  Model model;
  GpuSolver alone;
  GpuSolver fused;

  Compared(Model of, const SolverSettings& settings, bool rare = true)
      : model(std::move(of)),
        alone(gpu.programs, model, settings),
        fused((fusing.set_fusing(true, rare), fusing), model, settings) {}
  void step() {
    alone.step();
    fused.step();
  }
  std::size_t differences() const { return test::differences(alone.download(), fused.download()); }
};

}  // namespace

TEST_CASE("fused steps equal those of separate passes", "[gpu][.threads]") {
  struct Case {
    SolverChoice pair;
    double damping;
    bool grab;
    int colors = 0;
  };
  const auto [pair, damping, grab, colors] =
      GENERATE(Case{{Method::jacobi, Acceleration::chebyshev}, 0.01, false},
               Case{{Method::mass_splitting, Acceleration::anderson_positions}, 0, true},
               Case{{Method::gauss_seidel, Acceleration::none}, 0, false},
               Case{{Method::gauss_seidel, Acceleration::none}, 0.01, false, 5},
               Case{{Method::exact_xpbd, Acceleration::anderson}, 0, false},
               Case{{Method::vertex_descent, Acceleration::anderson}, 0.01, true},
               Case{{Method::two_level, Acceleration::anderson}, 0, false},
               Case{{Method::two_level, Acceleration::subspace}, 0.01, true});
  CAPTURE(name_of(pair.method), name_of(pair.acceleration), damping, colors);
  SolverSettings settings = with(pair);
  settings.substeps = 2;
  settings.iterations = 13;  // includes a refresh
  settings.colors = colors;
  Compared c(crushed(8, damping), settings);
  for (int i = 0; i < 3; ++i) c.step();
  CHECK(c.differences() == 0);

  const std::uint64_t before = gl::dispatch_count();
  c.fused.step();
  const std::uint64_t dispatches = gl::dispatch_count() - before;
  c.alone.step();
  CAPTURE(c.alone.dispatches_per_step(), dispatches);
  CHECK(dispatches >= c.fused.dispatches_per_step());  // more if one dispatch does not suffice
  CHECK(c.fused.dispatches_per_step() < c.alone.dispatches_per_step() / 3);

  if (grab) {
    const std::vector<GrabSpring> springs{{3, {0.02, 0.01, 0}, 50}, {20, {0.3, 0.05, 0.02}, 50}};
    c.alone.set_grab(springs);
    c.fused.set_grab(springs);
  }
  for (int i = 0; i < 2; ++i) c.step();
  CHECK(c.differences() == 0);
  CHECK(c.fused.timed_step().size() > 3);  // also pass by pass
  c.alone.step();
  CHECK(c.differences() == 0);
  const std::vector<Diagnostics> trace = c.fused.traced_substep(), expected = c.alone.traced_substep();
  REQUIRE(trace.size() == expected.size());
  for (std::size_t i = 0; i < trace.size(); ++i) CHECK(trace[i].elastic == expected[i].elastic);
}

TEST_CASE("fused steps of larger meshes equal those of separate passes", "[gpu][.threads]") {
  // More than the loops of one dispatch, so the stated number of loops of each kernel must be correct.
  const SolverChoice pair = GENERATE(SolverChoice{Method::jacobi, Acceleration::none},
                                     SolverChoice{Method::two_level, Acceleration::subspace});
  CAPTURE(name_of(pair.method));
  SolverSettings settings = with(pair);
  settings.iterations = 40;  // also for five threads
  Compared c(crushed(320, 0), settings);
  CAPTURE(c.model.tets.size());
  const std::uint64_t before = gl::dispatch_count();
  c.fused.step();
  CHECK(gl::dispatch_count() - before > c.fused.dispatches_per_step());
  c.alone.step();
  c.step();
  CHECK(c.differences() == 0);
}

TEST_CASE("fused steps leave the same regions at rest", "[gpu][.threads]") {
  // Two beams, one of which is pulled.
  Model model = two_bars(16, 0.4, {2e6, 0.4, 1000, 0.1, MaterialModel::signed_st_venant_kirchhoff});
  model.gravity.setZero();
  SolverSettings settings = with(SolverChoice{Method::two_level, Acceleration::subspace});
  settings.rest_speed = 1e-3;
  const bool also_partial = GENERATE(true, false);  // passes of the steps in which a part rests
  CAPTURE(also_partial);
  Compared c(std::move(model), settings, also_partial);
  const std::vector<GrabSpring> grab{{static_cast<std::uint32_t>(c.model.rest_positions.size() - 1), {0, 0.05, 0}, 20}};
  c.alone.set_grab(grab);
  c.fused.set_grab(grab);
  for (int i = 0; i < 30; ++i) c.step();
  CAPTURE(c.alone.share_solved());
  CHECK(c.fused.share_solved() < 1);
  CHECK(c.fused.share_solved() == c.alone.share_solved());
  CHECK(c.differences() == 0);
  if (also_partial) return;
  const auto dispatches = [&] {
    const std::uint64_t before = gl::dispatch_count();
    c.fused.step();
    c.alone.step();
    return gl::dispatch_count() - before;
  };
  const std::uint64_t one_by_one = dispatches();
  c.fusing.set_fusing(true);  // between two steps, as a window does
  c.fused.record_again();
  CHECK(dispatches() < one_by_one);
  CHECK(c.differences() == 0);
}
