// Kernels that read by texels compute what those do that read storage blocks, to the bit, where both sum in work
// groups.
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

const Material kDamped{2e4, 0.45, 1000, 0.01, MaterialModel::signed_st_venant_kirchhoff};

// 864 tets of two materials that fall and swing, with several clusters of forces and partial sums.
Model swinging_bar() {
  Model model = make_model(make_box(16, 3, 3, {0.4, 0.1, 0.1}), kDamped, at_left_end);
  model.materials.push_back({8e4, 0.3, 1200, 0, MaterialModel::st_venant_kirchhoff});
  for (std::size_t t = 0; t < model.tets.size() / 3; ++t) model.tet_material[t] = 1;
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
    if (!model.held()[v]) model.initial_velocity[v] = Vector3d(0, 0, 2 * model.rest_positions[v].x());
  return model;
}

State after_steps(const Model& model, const SolverSettings& settings, gl::LoadPath loads, gl::Sums sums) {
  const std::unique_ptr<Context> context = make_context({context_names().front()});
  gl::ProgramCache programs(source_dir() / "shaders", loads, sums);
  GpuSolver solver(programs, model, settings);
  solver.finish_background();
  for (int step = 0; step < 5; ++step) solver.step();
  return solver.download();
}

void check_paths(const Model& model, const SolverSettings& settings) {
  const State blocks = after_steps(model, settings, gl::LoadPath::storage, gl::Sums::in_groups),
              texels = after_steps(model, settings, gl::LoadPath::texel, gl::Sums::in_groups);
  REQUIRE(largest_displacement(blocks) > 0.01);
  CHECK(blocks.displacement == texels.displacement);
  CHECK(blocks.velocity == texels.velocity);
}

}  // namespace

TEST_CASE("states are the same to the bit by storage blocks and by texels", "[gpu]") {
  SolverSettings settings = frames();
  settings.iterations = 6;
  settings.rest_speed = 0;
  SECTION("with every method and acceleration") {
    for (const SolverChoice& choice : solver_choices()) {
      settings.method = choice.method;
      settings.acceleration = choice.acceleration;
      CAPTURE(name_of(choice.method), name_of(choice.acceleration));
      check_paths(swinging_bar(), settings);
    }
  }
  SECTION("of quadratic tets") { check_paths(quadratic(swinging_bar()), settings); }
  SECTION("where iterations end by a tolerance") {
    settings.tolerance = 1e-4;
    check_paths(swinging_bar(), settings);
  }
}
