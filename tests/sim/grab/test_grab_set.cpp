// Several grabs at once: the force of each against double precision, the balance of forces, violent ones.
#include <catch2/catch.hpp>
#include <random>

#include "app/session/graphics.h"
#include "app/session/open_input.h"
#include "base/file.h"
#include "sim/grab/grab_set.h"
#include "sim/grab/resolve_grab.h"
#include "sim/mesh/tet_faces.h"
#include "sim/simulation/simulation.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/headless.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

constexpr double kBeamRadius = 0.17;  // half the diagonal of the beam [m]

// Hangs from its end at y = 0.3.
Model hanging_beam(double damping = 0.05) {
  TetMesh mesh = make_box(3, 9, 3, {0.1, 0.3, 0.1});
  return make_model(mesh, {1e5, 0.3, 1000, damping}, [](const Vector3d& x) { return x.y() > 0.3 - 1e-9; });
}

// Two overlapping patches at the lower end.
std::vector<GrabSpring> two_grabs(const Model& model) {
  std::vector<GrabSpring> springs;
  const std::array<Vector3d, 2> at{Vector3d(0.03, 0, 0.05), Vector3d(0.07, 0, 0.05)},
      to{Vector3d(0.02, -0.01, 0), Vector3d(-0.005, 0.02, 0.01)};
  for (std::uint32_t h = 0; h < 2; ++h) {
    const std::vector<PatchVertex> patch =
        grab_patch(model, model.rest_positions, at[h], 0.06, tet_at(model.tets, model.rest_positions, at[h]));
    for (const PatchVertex& p : patch) springs.push_back({p.vertex, to[h], p.share * (h ? 300 : 800), h});
  }
  return springs;
}

struct Surface {
  explicit Surface(const Model& model) : drawn{boundary_triangles(model.tets), model.rest_positions} {}
  VisualSurface drawn;
  Hit hit(const Model& model, const Ray& ray) const {
    const auto found = pick(ray, drawn.triangles, model.rest_positions);
    REQUIRE(found);
    return *found;
  }
};

Ray from_front(double x, double y) { return {{x, y, 1}, -Vector3d::UnitZ()}; }

}  // namespace

TEST_CASE("the force of each of two overlapping grabs is that of the exact step") {
  const Model model = hanging_beam();
  const std::vector<GrabSpring> springs = two_grabs(model);
  std::vector<std::uint32_t> place;
  REQUIRE(joined(springs, place).size() < springs.size());  // the patches share vertices
  SolverSettings settings;
  settings.iterations = 60;
  const SolverChoice pair = GENERATE(SolverChoice{Method::two_level, Acceleration::subspace},
                                     SolverChoice{Method::vertex_descent, Acceleration::anderson});
  settings.method = pair.method;
  settings.acceleration = pair.acceleration;
  test::Gpu gpu;
  GpuSolver solver(gpu.programs, model, settings);
  solver.set_grab(springs);
  reference::NewtonSolver newton(model, settings);
  newton.set_springs(springs);
  State exact = initial_state(model);
  Diagnostics d;
  for (int i = 0; i < 3; ++i) {
    solver.step();
    newton.step(exact);
  }
  solver.request_diagnostics();
  d = *solver.take_diagnostics(true);
  const std::vector<GrabForce> expected = forces_of_grabs(springs, exact.displacement);
  REQUIRE(d.grab_forces.size() == 2);
  Vector3d sum(0, 0, 0);
  for (std::size_t h = 0; h < 2; ++h) {
    CAPTURE(name_of(pair.method), h, d.grab_forces[h].force.transpose(), expected[h].force.transpose());
    CHECK(d.grab_forces[h].grab == h);
    // The step is solved to 1e-3 of its motion or better, and forces are stiffness times that.
    CHECK((d.grab_forces[h].force - expected[h].force).norm() < 2e-3 * expected[h].force.norm());
    sum += d.grab_forces[h].force;
  }
  CHECK((sum - d.grab_force).norm() < 1e-5 * (d.grab_forces[0].force.norm() + d.grab_forces[1].force.norm()));

  solver.set_grab({});
  solver.step();
  solver.request_diagnostics();
  CHECK(solver.take_diagnostics(true)->grab_forces.empty());
}

TEST_CASE(
    "a hanging beam with a grab: the supports carry its weight and the pull, and the balance shows whether a step is "
    "solved") {
  const Model model = hanging_beam();
  const Vector3d weight = weight_of(model);
  const std::vector<GrabSpring> springs = two_grabs(model);
  State hanging = initial_state(model);
  SolverSettings settings;
  reference::NewtonSolver newton(model, settings);
  newton.set_springs(springs);
  REQUIRE(newton.solve_static(hanging).converged);
  Vector3d pull(0, 0, 0);
  for (const GrabForce& f : forces_of_grabs(springs, hanging.displacement)) pull += f.force;
  const Vector3d exact = reference::measure(model, hanging).fixed_reaction;
  CAPTURE(exact.transpose(), pull.transpose(), weight.transpose());
  // Static to 1e-10 of the forces: the sum over 100 vertices is off by at most ten times that.
  CHECK((exact + pull + weight).norm() < 1e-8 * exact.norm());
  CHECK(pull.norm() > 0.05 * weight.norm());

  // The GPU solver starts from that state: nothing moves, and it computes the same forces. Positions of 0.1 m in
  // float32 are accurate to 4e-9 m, and a tet's forces are E times its size of 0.03 m times that: some 1e-5 N of 30 N,
  // at a hundred vertices.
  test::Gpu gpu;
  GpuSolver solver(gpu.programs, model, settings);
  solver.set_grab(springs);
  solver.upload(hanging);
  for (int i = 0; i < 5; ++i) solver.step();
  solver.request_diagnostics();
  const Diagnostics still = *solver.take_diagnostics(true);
  CAPTURE(still.reaction.transpose(), still.grab_force.transpose(), still.inertia.transpose(), still.imbalance(weight));
  CHECK((still.reaction - exact).norm() < 1e-3 * exact.norm());
  CHECK((still.grab_force - pull).norm() < 1e-3 * exact.norm());
  CHECK(still.imbalance(weight) < 1e-3);

  // In motion the same sum holds with mass times acceleration, but not with too few iterations.
  const auto imbalance = [&](SolverChoice pair, int iterations) {
    SolverSettings few = settings;
    few.method = pair.method;
    few.acceleration = pair.acceleration;
    few.iterations = iterations;
    GpuSolver falling(gpu.programs, model, few);
    falling.set_grab(springs);
    for (int i = 0; i < 4; ++i) falling.step();
    falling.request_diagnostics();
    return falling.take_diagnostics(true)->imbalance(weight);
  };
  const double solved = imbalance({Method::two_level, Acceleration::subspace}, 40),
               unsolved = imbalance({Method::jacobi, Acceleration::none}, 2);
  CAPTURE(solved, unsolved);
  CHECK(solved < 1e-2);
  CHECK(unsolved > 0.05);
  CHECK(unsolved > 10 * solved);
}

TEST_CASE("grabs stay, are taken up again and released one by one") {
  const Model model = hanging_beam();
  const Surface surface(model);
  GrabSet grabs;
  REQUIRE(grabs.take(model, surface.drawn, model.rest_positions, surface.hit(model, from_front(0.05, 0.02)),
                     kBeamRadius, {}));
  REQUIRE(grabs.following());
  grabs.stay();
  CHECK_FALSE(grabs.following());
  REQUIRE(grabs.take(model, surface.drawn, model.rest_positions, surface.hit(model, from_front(0.05, 0.15)),
                     kBeamRadius, {}));
  REQUIRE(grabs.all().size() == 2);
  CHECK(grabs.follows(1));
  CHECK(grabs.all()[0].id != grabs.all()[1].id);
  const std::vector<GrabSpring> both = grabs.springs(1e-3);
  CHECK(both.size() == grabs.all()[0].grab.vertices().size() + grabs.all()[1].grab.vertices().size());
  grabs.observe({{grabs.all()[1].id, {1, 2, 3}}});
  CHECK(grabs.all()[0].grab.force().norm() == 0);
  CHECK(grabs.all()[1].grab.force() == Vector3d(1, 2, 3));
  grabs.take_up(0);
  CHECK(grabs.follows(0));
  grabs.let_go(1);
  CHECK(grabs.follows(0));
  grabs.let_go_following();
  CHECK(grabs.empty());
  CHECK(grabs.springs(1e-3).empty());
}

TEST_CASE("grabs that stay become grabs of the scene with the same springs") {
  const Model model = hanging_beam();
  const Surface surface(model);
  GrabSet grabs;
  const Hit hit = surface.hit(model, from_front(0.05, 0.02));
  REQUIRE(grabs.take(model, surface.drawn, model.rest_positions, hit, kBeamRadius, {}));
  CHECK(grabs.staying(model).empty());  // it follows the mouse
  Grab& grab = *grabs.following();
  grab.point_at({{0.09, 0.03, 1}, -Vector3d::UnitZ()}, -Vector3d::UnitZ());
  std::vector<GrabSpring> springs;
  for (int step = 0; step < 200; ++step) springs = grab.springs(1e-2);
  grabs.stay();
  const std::vector<ScriptedGrab> scripted = grabs.staying(model);
  REQUIRE(scripted.size() == 1);
  CHECK((std::get<Vector3d>(scripted[0].where) - hit.point).norm() < 1e-12);
  CHECK((scripted[0].translate - (grab.target() - hit.point)).norm() < 1e-12);

  Scene scene;
  scene.grabs = scripted;
  const ResolvedGrab resolved = resolve_grab(scene, 0, model);
  std::vector<GrabSpring> again = with_grabs_at_last({}, std::array{resolved});
  REQUIRE(again.size() == springs.size());
  const auto by_vertex = [](const GrabSpring& a, const GrabSpring& b) { return a.vertex < b.vertex; };
  std::sort(springs.begin(), springs.end(), by_vertex);
  std::sort(again.begin(), again.end(), by_vertex);
  for (std::size_t i = 0; i < springs.size(); ++i) {
    CAPTURE(i);
    CHECK(again[i].vertex == springs[i].vertex);
    CHECK(again[i].stiffness == Approx(springs[i].stiffness));
    CHECK((again[i].target - springs[i].target).norm() < 1e-12);
  }
}

TEST_CASE("the size of a patch changes during a grab, depth follows the view, a push goes into the surface") {
  const Model model = hanging_beam();
  const Surface surface(model);
  const Hit hit = surface.hit(model, from_front(0.05, 0.15));
  GrabSettings settings{0.1, 3};
  Grab grab;
  REQUIRE(grab.take(model, surface.drawn, model.rest_positions, hit, kBeamRadius, settings));
  const std::size_t few = grab.vertices().size();
  settings.radius = 0.5;
  grab.set_size(model, settings);
  CHECK(grab.vertices().size() > few);
  CHECK(grab.patch_radius() == Approx(0.5 * kBeamRadius));
  CHECK(grab.stiffness() == Approx(3 * 1e5 * 0.5 * kBeamRadius));

  const Vector3d forward = -Vector3d::UnitZ();
  const Vector3d before = grab.pointer();
  grab.go_deeper(0.02, forward);
  CHECK((grab.pointer() - before - 0.02 * forward).norm() < 1e-15);
  grab.point_at({{0.08, 0.15, 1}, forward}, forward);  // stays at that depth
  CHECK((grab.pointer() - Vector3d(0.08, 0.15, 0.08)).norm() < 1e-12);

  settings.push = true;
  REQUIRE(grab.take(model, surface.drawn, model.rest_positions, hit, kBeamRadius, settings));
  CHECK((grab.pointer() - hit.point - Vector3d(0, 0, -0.25 * kBeamRadius)).norm() < 1e-12);
  grab.go_deeper(0.01, Vector3d::UnitX());  // into the surface, for any view
  CHECK((grab.pointer() - hit.point - Vector3d(0, 0, -0.25 * kBeamRadius - 0.01)).norm() < 1e-12);
}

TEST_CASE("a patch without free vertices keeps its previous size") {
  // Two rows are clamped, the triangle between them is grabbed: its neighbors below are free.
  const Model model = make_model(make_box(3, 9, 3, {0.1, 0.3, 0.1}), {1e5, 0.3, 1000, 0},
                                 [](const Vector3d& x) { return x.y() > 0.26; });
  const Surface surface(model);
  GrabSettings settings{0.4, 3};
  Grab grab;
  REQUIRE(grab.take(model, surface.drawn, model.rest_positions, surface.hit(model, from_front(0.05, 0.28)), kBeamRadius,
                    settings));
  const std::vector<std::uint32_t> held = grab.vertices();
  const double stiffness = grab.stiffness();
  settings.radius = 0.01;
  grab.set_size(model, settings);
  CHECK(grab.vertices() == held);
  CHECK(grab.stiffness() == stiffness);
  CHECK(grab.patch_radius() == Approx(0.4 * kBeamRadius));
  for (const GrabSpring& s : grab.springs(1e-3)) CHECK(s.target.allFinite());
}

TEST_CASE("a fine surface in few large tets is grabbed by the tet below the hit point") {
  Model model =
      make_model(make_box(1, 1, 1, {0.3, 0.3, 0.3}), {1e5, 0.3, 1000, 0}, [](const Vector3d&) { return false; });
  // A surface triangle inside, far from any vertex of the lattice and much smaller than a tet.
  const auto first = static_cast<std::uint32_t>(model.rest_positions.size());
  VisualSurface surface{{{first, first + 1, first + 2}}, model.rest_positions};
  const std::vector<Vector3d> corners{{0.13, 0.16, 0.21}, {0.14, 0.16, 0.21}, {0.13, 0.17, 0.21}};
  surface.rest_positions.insert(surface.rest_positions.end(), corners.begin(), corners.end());
  model.embedded = embed(corners, model.rest_positions, model.tets);
  const auto hit = pick(from_front(0.133, 0.163), surface.triangles, surface.rest_positions);
  REQUIRE(hit);
  Grab grab;
  REQUIRE(grab.take(model, surface, surface.rest_positions, *hit, kBeamRadius, {0.01, 3}));
  Vector3d middle(0, 0, 0);
  double stiffness = 0;
  for (const GrabSpring& s : grab.springs(1e-3))
    middle += s.stiffness * model.rest_positions[s.vertex], stiffness += s.stiffness;
  CHECK(grab.vertices().size() == 4);
  CHECK((middle / stiffness - hit->point).norm() < 1e-9);  // the pull acts exactly at the hit point
}

TEST_CASE("three violent grabs neither make the body diverge nor detach from it") {
  const Model model = hanging_beam(0.1);
  const Surface surface(model);
  test::Gpu gpu;
  SolverSettings settings;
  GpuSolver solver(gpu.programs, model, settings);
  GrabSet grabs;
  for (const double y : {0.03, 0.12, 0.2}) {
    GrabSettings how;
    how.push = y == 0.12;
    REQUIRE(grabs.take(model, surface.drawn, model.rest_positions, surface.hit(model, from_front(0.05, y)), kBeamRadius,
                       how));
  }
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-4 * kBeamRadius, 4 * kBeamRadius);
  double farthest = 0;
  for (int i = 0; i < 150; ++i) {
    if (i % 3 == 0)
      for (std::size_t h = 0; h < 3; ++h) {
        grabs.take_up(h);
        grabs.following()->point_at(from_front(uniform(random), uniform(random)), -Vector3d::UnitZ());
        grabs.following()->go_deeper(0.2 * uniform(random), -Vector3d::UnitZ());
      }
    solver.set_grab(grabs.springs(settings.time_step));
    solver.step();
    solver.request_diagnostics();
    const Diagnostics d = *solver.take_diagnostics(true);
    grabs.observe(d.grab_forces);
    CAPTURE(i, d.max_speed, d.inverted);
    REQUIRE(d.finite);
    farthest = std::max(farthest, largest_displacement(solver.download()));
  }
  solver.set_grab({});
  for (int i = 0; i < 300; ++i) solver.step();
  solver.request_diagnostics();
  const Diagnostics d = *solver.take_diagnostics(true);
  CAPTURE(farthest / kBeamRadius, d.inverted, d.max_speed);
  CHECK(farthest < 4 * kBeamRadius);
  CHECK(d.finite);
  CHECK(d.max_speed < kBeamRadius);
}
