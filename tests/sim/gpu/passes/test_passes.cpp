// Every kernel that all methods share, alone, against the same pass in double precision on random states.
// Tolerances: one or a few float32 operations per output, 6e-8 each; sums of n terms grow it by at most n.
// Covers: motion_targets, sim_buffers, sim/gpu/readback/surface_positions
#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "sim/ordering/morton_order.h"
#include "sim/reference/double_xpbd.h"
#include "sim/reference/elasticity.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"
#include "tests/support/gpu/unpack.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;
using reference::DoubleXpbd;
using reference::Vector6d;
using shared::vec4;

TEST_CASE("previous strain is the Green strain of the start of the substep", "[gpu]") {
  const gl::LoadPath path = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  Gpu gpu(path);
  const Model model = block();
  SimBuffers buffers(model);
  const State state = random_state(model, 0.004, 6);
  buffers.upload_state(model, state);
  const std::vector<vec4> u = buffers.displacement.read<vec4>();
  buffers.previous_displacement.upload(0, buffers.previous_displacement.bytes(), u.data());
  const gl::Buffer strain("strain", bytes_of_previous_strain(gpu.programs, buffers));
  gl::ComputePass(
      gpu.programs.compute("sim/step/previous_strain.comp"),
      with_pairs({{"previous_displacement", &buffers.previous_displacement}, {"previous_strain", &strain}}, buffers),
      buffers.pair_and_single_count(), constants_of_pairs(buffers))
      .run();
  const DoubleXpbd exact(model, {});
  std::vector<Vector3d> expected;
  for (const std::uint32_t t : paired_tets(model).order) {
    const Vector6d e = exact.strain(t, state.displacement);
    expected.push_back(e.head<3>());
    expected.push_back(e.tail<3>());
  }
  std::vector<Vector3d> got;
  const std::vector<float> values = strain.read<float>();
  const std::size_t stride = path == gl::LoadPath::storage ? 3 : 4;  // floats
  for (std::size_t k = 0; k + stride <= values.size() && got.size() < expected.size(); k += stride)
    got.emplace_back(values[k], values[k + 1], values[k + 2]);
  CHECK(relative_rms(got, expected) < 1e-6);
}

TEST_CASE("published positions and heat map scalars", "[gpu]") {
  const auto color =
      GENERATE(ColorBy::none, ColorBy::region, ColorBy::strain, ColorBy::von_mises, ColorBy::displacement,
               ColorBy::velocity, ColorBy::volume_ratio, ColorBy::largest_stress, ColorBy::smallest_stress);
  const auto law = GENERATE(MaterialModel::st_venant_kirchhoff, MaterialModel::signed_st_venant_kirchhoff,
                            MaterialModel::stable_neo_hookean, MaterialModel::neo_hookean, MaterialModel::mooney_rivlin,
                            MaterialModel::squared);
  Gpu gpu;
  Model model = block();
  model.materials[0].model = law;
  GpuSolver solver(gpu.programs, model, {});
  const State state = random_state(model, 0.002, 5);
  solver.upload(state);
  solver.set_color(color);
  solver.publish();
  const std::vector<vec4> got = solver.positions().read<vec4>();
  // For each tet, in double precision.
  const auto value_of = [&](const Tet& tet) {
    const auto& x = model.rest_positions;
    const auto& u = state.displacement;
    const LinearTet rest({x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]});
    const Corners corners{u[tet[0]], u[tet[1]], u[tet[2]], u[tet[3]]};
    const Eigen::Matrix3d f = rest.deformation_gradient(corners);
    if (color == ColorBy::strain) return reference::green_strain_matrix(rest, corners).norm();
    if (color == ColorBy::von_mises) return reference::von_mises(f, model.materials[0]);
    if (color == ColorBy::volume_ratio) return f.determinant();
    const Eigen::Matrix3d cauchy =
        reference::first_piola_stress(f, model.materials[0]) * f.transpose() / std::abs(f.determinant());
    const Vector3d principal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(0.5 * (cauchy + cauchy.transpose())).eigenvalues();
    return color == ColorBy::largest_stress ? principal[2] : principal[0];
  };
  std::vector<double> weight(got.size(), 0), scalar(got.size(), 0);
  double size = 0;  // of the values, as the scale for those that nearly cancel
  for (const Tet& tet : model.tets) {
    const auto& x = model.rest_positions;
    const double volume = signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) / 6, value = value_of(tet);
    size = std::max(size, std::abs(value));
    for (const auto v : tet) {
      weight[v] += volume;
      scalar[v] += volume * value;
    }
  }
  Eigen::Vector2d range(1e300, -1e300);
  for (std::size_t i = 0; i < got.size(); ++i) {
    const Vector3d expected = model.rest_positions[i] + state.displacement[i];
    CAPTURE(color, law, i, got[i].x, got[i].y, got[i].z, got[i].w, expected.transpose());
    CHECK((Vector3d(got[i].x, got[i].y, got[i].z) - expected).norm() < 2e-8);
    double shown = scalar[i] / weight[i];
    if (!is_heat_map(color)) shown = 0;
    if (color == ColorBy::displacement) shown = state.displacement[i].norm();
    if (color == ColorBy::velocity) shown = state.velocity[i].norm();
    // Stresses cancel in F S F^T and are divided by J, which is small in some tets here.
    const double margin = color == ColorBy::largest_stress || color == ColorBy::smallest_stress ? 1e-5 * size : 0;
    CHECK(got[i].w == Approx(shown).epsilon(1e-5).margin(margin));
    range = {std::min<double>(range.x(), got[i].w), std::max<double>(range.y(), got[i].w)};
  }
  CHECK((solver.shown_range() != nullptr) == is_heat_map(color));
  if (!solver.shown_range()) return;
  solver.shown_range()->request();
  const auto found = solver.shown_range()->take(true);
  REQUIRE(found);
  CHECK(found->smallest == range.x());
  CHECK(found->largest == range.y());
  std::vector<double> ranked;
  for (const auto& p : got) ranked.push_back(std::abs(p.w - quantity_of(color).neutral.value_or(0)));
  std::sort(ranked.begin(), ranked.end());
  const std::size_t most = (98 * ranked.size() + 99) / 100;  // the 98th percentile has so many values up to it
  CHECK(found->usual == Approx(ranked[most - 1]).epsilon(1e-6).margin(1e-7));
  CHECK(!solver.shown_range()->take(true));
}

TEST_CASE("principal stresses stay accurate where two are equal", "[gpu]") {
  // One tet stretched along an axis that is not a coordinate axis: uniaxial strain, two equal smaller stresses.
  Gpu gpu;
  TetMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tets = {{0, 1, 2, 3}};
  mesh.regions = {0};
  const Model model = make_model(mesh, soft, [](const Vector3d&) { return false; });
  GpuSolver solver(gpu.programs, model, {});
  const Vector3d axis = Vector3d(1, 2, -0.5).normalized();
  const double stretch = 0.25, strain = stretch + 0.5 * stretch * stretch, ratio = 1 + stretch;
  State state = initial_state(model);
  for (std::size_t i = 0; i < 4; ++i) state.displacement[i] = stretch * axis * axis.dot(mesh.positions[i]);
  solver.upload(state);
  const double lambda =
      soft.young_modulus * soft.poisson_ratio / ((1 + soft.poisson_ratio) * (1 - 2 * soft.poisson_ratio));
  const double mu = soft.young_modulus / (2 * (1 + soft.poisson_ratio));
  const double along = (lambda + 2 * mu) * strain * ratio, across = lambda * strain / ratio;
  const auto shown = [&](ColorBy color) {
    solver.set_color(color);
    solver.publish();
    return static_cast<double>(solver.positions().read<vec4>()[0].w);
  };
  CHECK(shown(ColorBy::largest_stress) == Approx(along).epsilon(2e-6));
  CHECK(shown(ColorBy::smallest_stress) == Approx(across).epsilon(2e-6));
  CHECK(shown(ColorBy::volume_ratio) == Approx(ratio).epsilon(1e-6));
}

TEST_CASE("prescribed vertices follow their motion exactly", "[gpu]") {
  Gpu gpu;
  Model model = block();
  Motion motion;
  motion.vertices = {30, 31, 32};
  motion.translate = {0.01, 0.02, -0.01};
  motion.start = 0.05;
  motion.duration = 0.1;
  model.motions = {motion};
  GpuSolver solver(gpu.programs, model, {});
  for (int step = 1; step <= 12; ++step) {
    solver.step();
    const State state = solver.download();
    const double share = std::clamp((step / 60.0 - 0.05) / 0.1, 0.0, 1.0);
    CAPTURE(step, share, state.displacement[31].transpose());
    CHECK((state.displacement[31] - share * motion.translate).norm() < 1e-8);
  }
}
