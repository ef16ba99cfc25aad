// For any order of a mesh's vertices the solver computes the same to the bit, and all its inputs and outputs use the
// model's numbering.
// Covers: sim/gpu/readback/step_snapshot
#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "sim/gpu/readback/step_snapshot.h"
#include "sim/gpu/solver.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;
using shared::vec4;

namespace {

// Clamped at one end, moved at the other; with two materials.
Model moved_bar() {
  Model model = bar(0.01);
  model.materials.push_back(model.materials.front());
  model.materials.back().young_modulus *= 10;
  for (std::size_t t = 0; t < model.tets.size(); t += 3) model.tet_material[t] = 1;
  Motion motion;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() > 0.2 - 1e-9) motion.vertices.push_back(v);
  for (const std::uint32_t v : motion.vertices)
    motion.targets.push_back(model.rest_positions[v] + Vector3d(0.01, 0, 0.05 * model.rest_positions[v].y()));
  motion.duration = 0.05;
  model.motions.push_back(motion);
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
    if (!model.held()[v]) model.initial_velocity[v] = Vector3d(0.1, 2 * model.rest_positions[v].x(), -0.3);
  return model;
}

// The same model with vertex v renamed to[v].
struct Renumbered {
  Model model;
  std::vector<std::uint32_t> to;

  explicit Renumbered(const Model& of) : model(of), to(of.rest_positions.size()) {
    std::iota(to.begin(), to.end(), 0u);
    std::shuffle(to.begin(), to.end(), std::mt19937(5));
    const auto rename = [&](auto& vertices) {
      for (std::uint32_t& v : vertices) v = to[v];
    };
    for (Tet& tet : model.tets) rename(tet);
    rename(model.fixed);
    std::sort(model.fixed.begin(), model.fixed.end());
    for (Motion& motion : model.motions) rename(motion.vertices);
    model.rest_positions = moved(of.rest_positions);
    model.initial_velocity = moved(of.initial_velocity);
  }
  template <class T>
  std::vector<T> moved(const std::vector<T>& values) const {
    std::vector<T> result(values.size());
    for (std::size_t v = 0; v < to.size(); ++v) result[to[v]] = values[v];
    return result;
  }
};

std::size_t differences(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  std::size_t count = 0;
  for (std::size_t v = 0; v < a.size(); ++v) count += a[v] != b[v];
  return count;
}

std::vector<Vector3d> published(GpuSolver& solver, std::size_t first, std::size_t count) {
  solver.publish();
  const auto positions = solver.positions().read<vec4>();
  std::vector<Vector3d> result;  // x, y and the heat map's scalar
  for (std::size_t i = first; i < first + count; ++i)
    result.emplace_back(positions[i].x, positions[i].y, positions[i].w);
  return result;
}

}  // namespace

TEST_CASE("the order of a mesh's vertices has no effect", "[gpu]") {
  const SolverChoice pair = any_pair();
  CAPTURE(name_of(pair.method), name_of(pair.acceleration));
  Gpu gpu;
  const Model model = moved_bar();
  const Renumbered other(model);
  const std::size_t count = model.rest_positions.size();
  EmbeddedPoints drawn, other_drawn;
  drawn.points = {{0.101, 0.02, 0.03}, {0.15, 0.05, 0.01}};
  drawn.ties = {{model.tets[200], {0.25, 0.25, 0.25, 0.25}}, {model.tets[301], {0.7, 0.1, 0.1, 0.1}}};
  other_drawn = drawn;
  for (auto& tie : other_drawn.ties)
    for (std::uint32_t& v : tie.vertices) v = other.to[v];
  GpuSolver a(gpu.programs, model, with(pair), drawn), b(gpu.programs, other.model, with(pair), other_drawn);
  REQUIRE(a.buffers().placement.place != b.buffers().placement.place);

  const std::vector<GrabSpring> springs{
      {60, {0.01, 0.02, 0}, 50, 0}, {61, {0.01, 0.02, 0}, 50, 0}, {75, {-0.01, 0, 0.01}, 80, 1}};
  std::vector<GrabSpring> other_springs = springs;
  for (GrabSpring& spring : other_springs) spring.vertex = other.to[spring.vertex];
  std::vector<float> errors(count);
  std::iota(errors.begin(), errors.end(), 0.0f);
  a.set_vertex_errors(errors);
  b.set_vertex_errors(other.moved(errors));
  a.set_probe(77);
  b.set_probe(other.to[77]);
  for (int i = 0; i < 6; ++i) {
    if (i == 2) a.set_grab(springs), b.set_grab(other_springs);
    if (i == 5) a.set_grab({}), b.set_grab({});
    a.step();
    b.step();
  }
  const State state = a.download(), other_state = b.download();
  CHECK(differences(other.moved(state.displacement), other_state.displacement) == 0);
  CHECK(differences(other.moved(state.velocity), other_state.velocity) == 0);
  for (const ColorBy color : {ColorBy::von_mises, ColorBy::error}) {
    a.set_color(color);
    b.set_color(color);
    CHECK(differences(other.moved(published(a, 0, count)), published(b, 0, count)) == 0);
    CHECK(differences(published(a, count, 2), published(b, count, 2)) == 0);
  }
  a.request_diagnostics();
  b.request_diagnostics();
  const auto d = a.take_diagnostics(true), e = b.take_diagnostics(true);
  REQUIRE(d->probe);
  CHECK(*d->probe == *e->probe);
  CHECK(*d->probe == state.displacement[77]);
  CHECK(d->elastic == e->elastic);
}

TEST_CASE("grabs, diverged vertices, kept states and snapshots use the model's vertices", "[gpu]") {
  Gpu gpu;
  const Renumbered renumbered(bar());
  const Model& model = renumbered.model;
  GpuSolver solver(gpu.programs, model, with(SolverChoice{Method::jacobi, Acceleration::none}));
  const std::uint32_t held = renumbered.to[70];

  // One vertex is pulled, and the same vertex moves farthest.
  solver.set_grab({{held, {0, 0, 0.02}, 500}});
  solver.step();
  const State pulled = solver.download();
  const auto farthest = std::max_element(pulled.displacement.begin(), pulled.displacement.end(),
                                         [](const Vector3d& x, const Vector3d& y) { return x.norm() < y.norm(); });
  CHECK(farthest - pulled.displacement.begin() == held);
  solver.request_diagnostics();
  const auto diagnostics = solver.take_diagnostics(true);
  REQUIRE(diagnostics->grab_forces.size() == 1);
  CHECK(diagnostics->grab_forces[0].force.z() > 0);

  StepSnapshot snapshot;
  snapshot.request(solver.buffers());
  const auto taken = snapshot.take(solver.buffers(), true);
  REQUIRE(taken);
  CHECK(differences(taken->solution, pulled.displacement) == 0);

  solver.request_check();
  REQUIRE_FALSE(solver.take_check(true)->diverged);
  CHECK(differences(solver.download_valid().displacement, pulled.displacement) == 0);

  // One iteration spreads a divergence only to the neighbors: a wrong number would name a finite vertex.
  State lost = pulled;
  lost.displacement[held].y() = std::numeric_limits<double>::quiet_NaN();
  solver.set_grab({});
  SolverSettings once = solver.settings();
  once.iterations = 1;
  solver.set_settings(once);
  solver.upload(lost);
  solver.step();
  solver.request_check();
  const auto verdict = solver.take_check(true);
  REQUIRE(verdict->diverged);
  CHECK_FALSE(solver.download().displacement[*verdict->diverged].allFinite());
}
