// Vertex block descent with tets that need a guard: their vertices are deferred to the end of their color.
// Covers: sim/gpu/passes/recording
#include "sim/gpu/methods/vertex_descent.h"

#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "sim/ordering/mesh_order.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

Model thin_beam(MaterialModel material) {
  return make_model(make_box(6, 3, 3, {0.3, 0.1, 0.1}), {2e4, 0.3, 1000, 0, material},
                    [](const Vector3d& x) { return x.x() < 1e-9; });
}

}  // namespace

TEST_CASE("deferred vertices move as they do in place", "[gpu]") {
  Gpu gpu(GENERATE(gl::LoadPath::texel, gl::LoadPath::storage));
  const Model model = thin_beam(MaterialModel::signed_st_venant_kirchhoff);
  SolverSettings settings;
  settings.method = Method::vertex_descent;
  const double amplitude = GENERATE(0.0, 0.004, 0.02);  // [m] the last one inverts many tets
  const State state = random_state(model, amplitude, 5);
  const VertexColoring coloring = color_vertices(model.tets, model.held());
  const auto colors = static_cast<std::uint32_t>(coloring.color_count()),
             vertices = static_cast<std::uint32_t>(coloring.order.size());
  const auto descend = [&](DeferredTets* deferred) {
    SimBuffers buffers(model);
    buffers.upload_step(model, settings, IntegratorStage{settings.substep()});
    buffers.upload_state(model, state);
    prediction(gpu.programs, buffers, nullptr, {false}).run();
    const Features features = features_of(model);
    const gl::Buffer no_strain;
    const EnergyTerms no_terms{};
    const Recording recording{gpu.programs, buffers, features, no_strain, no_terms, deferred};
    const VertexDescentMethod method(model, buffers);
    std::uint32_t most = 0;
    for (int iteration = 0; iteration < 3; ++iteration)
      for (const gl::ComputePass& pass : method.iteration(recording, iteration == 0)) {
        pass.run();
        if (deferred) most = std::max(most, deferred->count());
      }
    return std::pair(buffers.download_state(0).displacement, most);
  };
  DeferredTets deferred({colors, vertices});
  const auto [in_place, none] = descend(nullptr);
  const auto [later, most] = descend(&deferred);
  const double difference = relative_rms(later, in_place);
  CAPTURE(amplitude, most, difference);
  CHECK(difference < 1e-5);
  CHECK((most > 0) == (amplitude > 0.01));
}

TEST_CASE("a change of method allocates memory for the pairs that the new one defers", "[gpu]") {
  Gpu gpu;
  const Model model = thin_beam(MaterialModel::signed_st_venant_kirchhoff);
  SolverSettings settings;
  GpuSolver solver(gpu.programs, model, settings);
  CHECK(gl::bytes_by_buffer().at("deferred_items") == 4 * (4 + solver.buffers().pair_and_single_count()));
  const Model in_place = placed(model, mesh_order_of(model));  // in the solver's order
  const VertexColoring coloring = color_vertices(in_place.tets, in_place.held());
  settings.method = Method::vertex_descent;
  settings.acceleration = Acceleration::none;
  solver.set_settings(settings);
  CHECK(gl::bytes_by_buffer().at("deferred_items") == 4 * (4 * coloring.color_count() + coloring.order.size()));
  settings.method = Method::gauss_seidel;
  solver.set_settings(settings);
  CHECK_FALSE(gl::bytes_by_buffer().contains("deferred_items"));
}
