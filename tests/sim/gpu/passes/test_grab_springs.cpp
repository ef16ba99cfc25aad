// Springs of grabs: storage and forces.
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;
using shared::vec4;

TEST_CASE("a grab spring alone obeys implicit Euler", "[gpu]") {
  // One tet so soft that only the spring acts: (m / h^2 + k) (u - target) = m / h^2 (u~ - target).
  Gpu gpu;
  TetMesh mesh;
  mesh.positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  mesh.tets = {{0, 1, 2, 3}};
  mesh.regions = {0};
  Model model =
      make_model(mesh, {1e-3, 0.3, 1000, 0, MaterialModel::st_venant_kirchhoff}, [](const Vector3d&) { return false; });
  model.gravity.setZero();
  SolverSettings settings;
  GpuSolver solver(gpu.programs, model, settings);
  const double m = lumped_masses(model)[1], h = settings.substep();
  const double stiffness = GENERATE(1e-2, 1e1, 1e5);
  const Vector3d target(0.03, -0.02, 0.01);
  solver.set_grab({{1, target, stiffness}});
  solver.step();
  const Vector3d expected = target * stiffness / (m / (h * h) + stiffness);
  const State state = solver.download();
  CAPTURE(stiffness, state.displacement[1].transpose(), expected.transpose());
  CHECK((state.displacement[1] - expected).norm() < 1e-4 * expected.norm());
  solver.request_diagnostics();
  const auto diagnostics = solver.take_diagnostics(true);
  const Vector3d force = stiffness * (target - expected);
  CAPTURE(diagnostics->grab_force.transpose(), force.transpose());
  CHECK((diagnostics->grab_force - force).norm() < 1e-3 * force.norm());
  CHECK(diagnostics->residual < 1e-4);  // the spring counts as a load

  solver.set_grab({});
  solver.step();
  solver.request_diagnostics();
  CHECK(solver.take_diagnostics(true)->grab_force.norm() == 0);
}

TEST_CASE("springs are stored at their vertices, however far apart these are, and removed afterwards", "[gpu]") {
  Gpu gpu;
  const Model model = make_model(make_box(19, 12, 11, {0.19, 0.12, 0.11}), soft,
                                 [](const Vector3d& x) { return x.y() < 1e-9; });  // 3,120 vertices
  const SimBuffers buffers(model);
  GrabSprings grab;
  grab.set_use(false, true, buffers.vertex_count);
  const auto check = [&](const std::vector<GrabSpring>& springs) {
    grab.set(springs);
    gl::ComputePass::Bindings bindings;
    grab.bind(TermUse::gradient, bindings);
    REQUIRE(bindings.size() == 1);
    std::vector<vec4> expected(buffers.vertex_count, vec4{});
    for (const GrabSpring& s : springs)
      expected[s.vertex] = {static_cast<float>(s.target.x()), 0, 0, static_cast<float>(s.stiffness)};
    const std::vector<vec4> got = bindings[0].second->read<vec4>();
    for (std::size_t v = 0; v < got.size(); ++v) {
      CAPTURE(v);
      REQUIRE((got[v].x == expected[v].x && got[v].w == expected[v].w));
    }
  };
  check({{3000, {1, 0, 0}, 5}, {7, {2, 0, 0}, 6}, {12, {3, 0, 0}, 7}, {1032, {4, 0, 0}, 8}});
  check({{3000, {9, 0, 0}, 5}, {7, {8, 0, 0}, 6}, {12, {7, 0, 0}, 7}, {1032, {6, 0, 0}, 8}});
  check({{2000, {1, 0, 0}, 3}});
}

TEST_CASE("a grab without stiffness changes nothing", "[gpu]") {
  Gpu gpu;
  const Model model = block();
  const auto method =
      GENERATE(Method::jacobi, Method::gauss_seidel, Method::exact_xpbd, Method::vertex_descent, Method::two_level);
  SolverSettings settings;
  settings.method = method;
  settings.acceleration = method == Method::two_level ? Acceleration::subspace : Acceleration::none;
  GpuSolver free(gpu.programs, model, settings), held(gpu.programs, model, settings);
  held.set_grab({{static_cast<std::uint32_t>(model.rest_positions.size() - 1), {0.1, 0.1, 0}, 0}});
  for (int i = 0; i < 5; ++i) {
    free.step();
    held.step();
  }
  const double distance = farthest(held.download(), free.download()), size = free.buffers().size;
  CAPTURE(name_of(method), distance);
  CHECK(distance < 1e-6 * size);
}
