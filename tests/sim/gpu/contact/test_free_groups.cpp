// Bodies that press each other and nothing else keep their momentum, however stiff they are.
#include "sim/gpu/contact/free_groups.h"

#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "tests/sim/gpu/contact/contact_scenes.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/touching_bodies.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using test::cube;
using test::soft_tissue;
using test::two_level;

// Cubes of 2 and 3 cm that meet off their middles, at 0.6 m/s.
Model stiff_cubes(double young_modulus) {
  const Model first = test::moved(cube(0.02, 2, soft_tissue(young_modulus)), {0, 0.004, 0.002}, {0.5, 0, 0});
  Model second = test::moved(cube(0.03, 3, soft_tissue(young_modulus)), {0.0245, 0, 0}, {-0.1, 0, 0});
  second.rest_positions.emplace_back(0.03, 0.02, 0.02);  // of no tet
  second.initial_velocity.emplace_back(0, 0, 0);
  Model model = test::beside(first, second, "second");
  model.gravity.setZero();
  return model;
}

Vector3d momentum_of(const Model& model, const State& state) {
  const std::vector<double> masses = lumped_masses(model);
  Vector3d sum(0, 0, 0);
  for (std::size_t v = 0; v < masses.size(); ++v) sum += masses[v] * state.velocity[v];
  return sum;
}

using Touch = std::array<std::uint32_t, 2>;

std::vector<std::uint32_t> groups_of(const Model& model, const std::vector<Touch>& touching,
                                     const std::vector<VertexStiffness>& springs) {
  const SimBuffers buffers(model);
  std::vector<PairRow> pairs;
  for (const auto& bodies : touching) pairs.emplace_back().bodies = bodies;
  FreeGroups groups(model, buffers);
  groups.begin(pairs, springs);
  return groups.groups().read<std::uint32_t>();
}

}  // namespace

TEST_CASE("stiff cubes that collide keep their momentum after ten iterations", "[gpu][contact]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const double young_modulus = GENERATE(2e4, 2e5, 2e6, 1e8);
  test::Gpu gpu(loads);
  const Model model = stiff_cubes(young_modulus);
  GpuSolver solver(gpu.programs, model, two_level());
  const Vector3d before = momentum_of(model, solver.download());
  for (int i = 0; i < 12; ++i) {
    solver.step();
    const Vector3d now = momentum_of(model, solver.download());
    CAPTURE(gl::name_of(loads), young_modulus, i, before.transpose(), now.transpose());
    REQUIRE((now - before).norm() < 1e-5 * before.norm());
  }
  const double first = solver.download().velocity.front().x();
  CAPTURE(young_modulus, first);
  CHECK(first < 0.2);  // of 0.5 m/s: they met
}

TEST_CASE("bodies that touch make a group, unless something holds one of them", "[gpu][contact]") {
  test::Gpu gpu;
  const Material tissue = soft_tissue(1e5);
  Model model = test::beside(cube(0.1, 2, tissue), test::moved(cube(0.1, 2, tissue), {0.2, 0, 0}, {0, 0, 0}), "second");
  model = test::beside(model, test::moved(cube(0.1, 2, tissue), {0.4, 0, 0}, {0, 0, 0}), "third");
  using Groups = std::vector<std::uint32_t>;
  CHECK(groups_of(model, {}, {}) == Groups{kNoBody, kNoBody, kNoBody});
  CHECK(groups_of(model, {Touch{1, 2}}, {}) == Groups{kNoBody, 1, 1});
  CHECK(groups_of(model, {Touch{1, 2}, Touch{0, 2}}, {}) == Groups{0, 0, 0});
  CHECK(groups_of(model, {Touch{0, 0}}, {}) == Groups{0, kNoBody, kNoBody});
  const SimBuffers buffers(model);
  const VertexStiffness of_second{buffers.placement.place[27 + 3], 100};  // 27 vertices a cube
  CHECK(groups_of(model, {Touch{1, 2}}, {of_second}) == Groups{kNoBody, kNoBody, kNoBody});
  CHECK(groups_of(model, {Touch{0, 0}, Touch{1, 2}}, {of_second}) == Groups{0, kNoBody, kNoBody});
}

}  // namespace fascia
