// Starts that are inside out are unfolded by another law, and then have their own again.
// Covers: unfolding
#include "sim/gpu/unfolding.h"

#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

Model bar_of(MaterialModel law) {
  Model model = bar();
  for (Material& material : model.materials) material.model = law;
  return model;
}

State collapsed(const Model& model) {
  State state = initial_state(model);
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < held.size(); ++v)
    if (!held[v]) state.displacement[v] = float32_of(Vector3d(0.1, 0.03, 0.03) - model.rest_positions[v]);
  return state;
}

}  // namespace

TEST_CASE("only bodies of laws with a logarithm that are inside out in large part need unfolding") {
  const Model model = bar_of(MaterialModel::squared);
  State state = initial_state(model);
  CHECK_FALSE(needs_unfolding(model, state));
  CHECK(is_unfolded(model, state));
  state.displacement[model.tets.back()[3]] -= Vector3d(0.1, 0.03, 0.03);  // a corner, to the middle: inverts a few tets
  CHECK_FALSE(needs_unfolding(model, state));
  CHECK_FALSE(is_unfolded(model, state));
  CHECK(needs_unfolding(model, collapsed(model)));
  for (const MaterialModel law : {MaterialModel::neo_hookean, MaterialModel::mooney_rivlin})
    CHECK(needs_unfolding(bar_of(law), collapsed(model)));
  for (const MaterialModel law : {MaterialModel::signed_st_venant_kirchhoff, MaterialModel::stable_neo_hookean})
    CHECK_FALSE(needs_unfolding(bar_of(law), collapsed(model)));
  std::vector<Material> materials(4);
  materials[0].model = MaterialModel::squared;
  materials[1].model = MaterialModel::neo_hookean;
  materials[2].model = MaterialModel::mooney_rivlin;
  materials[3].model = MaterialModel::stable_neo_hookean;
  take_unfolding_law(materials);
  for (int k = 0; k < 3; ++k) CHECK(materials[k].model == MaterialModel::signed_st_venant_kirchhoff);
  CHECK(materials[3].model == MaterialModel::stable_neo_hookean);
}

TEST_CASE("a body collapsed to a point unfolds, and then makes the steps of its own law", "[gpu]") {
  Gpu gpu;
  const Model model = bar_of(MaterialModel::squared);
  const SolverSettings settings;
  GpuSolver solver(gpu.programs, model, settings);
  const std::uint64_t dispatches = solver.dispatches_per_step();
  solver.upload(collapsed(model));
  for (int i = 0; i < 80; ++i) solver.step();
  const State after = solver.download();
  CHECK(is_unfolded(model, after));
  CHECK(solver.dispatches_per_step() == dispatches);
  GpuSolver fresh(gpu.programs, model, settings);
  fresh.upload(after);
  fresh.step();
  solver.step();
  CHECK(relative_rms(solver.download().displacement, fresh.download().displacement) < 1e-5);
}

TEST_CASE("an upright state ends the unfolding", "[gpu]") {
  Gpu gpu;
  const Model model = bar_of(MaterialModel::squared);
  GpuSolver solver(gpu.programs, model, {}), fresh(gpu.programs, model, {});
  solver.upload(collapsed(model));
  solver.step();
  const State start = random_state(model, 1e-3, 3);
  for (GpuSolver* each : {&solver, &fresh}) {
    each->upload(start);
    each->step();
  }
  CHECK(relative_rms(solver.download().displacement, fresh.download().displacement) == 0);
}
