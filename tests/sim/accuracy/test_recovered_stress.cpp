#include "sim/accuracy/recovered_stress.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sim/reference/box_model.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using reference::Vector6d;

namespace {

Material linear_law(double nu) {
  Material material = soft(1e5, nu);
  material.model = MaterialModel::st_venant_kirchhoff;
  return material;
}

/// A box whose vertices inside are moved, so that no two tets are alike.
Model irregular_box(const Material& material) {
  Model model = box_model(3, 3, 3, {0.3, 0.3, 0.3}, material);
  Random random(7);
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (!on_surface({0.3, 0.3, 0.3})(model.rest_positions[v])) model.rest_positions[v] += 0.02 * random.vector();
  model.file_mesh.positions = model.rest_positions;
  return model;
}

State displaced(const Model& model, const std::function<Vector3d(const Vector3d&)>& u) {
  State state = initial_state(model);
  for (std::size_t v = 0; v < state.displacement.size(); ++v) state.displacement[v] = u(model.rest_positions[v]);
  return state;
}

}  // namespace

TEST_CASE("the points of a tet integrate polynomials of degree 5 exactly") {
  // Over a tet of volume 1, the mean of L0^a L1^b L2^c L3^d is 3! a! b! c! d! / (a + b + c + d + 3)!.
  const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
  for (int a = 0; a <= 5; ++a)
    for (int b = 0; a + b <= 5; ++b)
      for (int c = 0; a + b + c <= 5; ++c) {
        double sum = 0;
        for (const VolumePoint& point : volume_points())
          sum += point.weight * std::pow(point.barycentric[0], a) * std::pow(point.barycentric[1], b) *
                 std::pow(point.barycentric[2], c);
        CAPTURE(a, b, c);
        CHECK(sum == Approx(6 * factorial(a) * factorial(b) * factorial(c) / factorial(a + b + c + 3)).epsilon(1e-12));
      }
}

TEST_CASE("a uniform stress is recovered exactly, and turns no vertex of it with the body") {
  const bool ten_nodes = GENERATE(false, true);
  const Model box = irregular_box(linear_law(0.4)), model = ten_nodes ? quadratic(box) : box;
  Random random(8);
  const Matrix3d stretch = Matrix3d::Identity() + 0.1 * Vector3d(1, -0.5, 0.2).asDiagonal().toDenseMatrix();
  const Matrix3d f = random.rotation() * stretch;
  const State state = displaced(model, [&](const Vector3d& x) -> Vector3d { return f * x - x; });
  const Matrix3d exact = stretch * reference::second_piola_stress(
                                       0.5 * (stretch.transpose() * stretch - Matrix3d::Identity()), linear_law(0.4));
  const RecoveredStress recovered(model, state);
  double largest = 0;
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (const VolumePoint& point : volume_points())
      largest = std::max(largest, (matrix_of(recovered.at(t, point.barycentric)) - exact).norm());
  CAPTURE(ten_nodes, largest, exact.norm());
  CHECK(largest < 1e-9 * exact.norm());
}

// A quadratic displacement in small strain: quadratic tets hold it, and the stress varies linearly. Without lateral
// contraction no pressure is averaged.
TEST_CASE("a linear stress is recovered exactly from quadratic tets") {
  const Model model = quadratic(irregular_box(linear_law(0)));
  const auto u = [](const Vector3d& x) -> Vector3d {
    return 1e-7 * Vector3d(x.x() * x.y() + x.z() * x.z(), x.y() * x.y(), x.x() * x.z() - x.y() * x.z());
  };
  const State state = displaced(model, u);
  const RecoveredStress recovered(model, state);
  double largest = 0, whole = 0;
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (const VolumePoint& point : volume_points()) {
      Vector3d x = Vector3d::Zero();
      for (int a = 0; a < 4; ++a)
        x += point.barycentric[a] * model.rest_positions[model.tets[t][static_cast<std::size_t>(a)]];
      Matrix3d gradient;
      gradient << x.y(), x.x(), 2 * x.z(), 0, 2 * x.y(), 0, x.z(), -x.z(), x.x() - x.y();
      const Matrix3d exact = 1e-7 * 1e5 * 0.5 * (gradient + gradient.transpose());
      largest = std::max(largest, (matrix_of(recovered.at(t, point.barycentric)) - exact).norm());
      whole = std::max(whole, exact.norm());
    }
  CAPTURE(largest, whole);
  CHECK(largest < 1e-5 * whole);  // the squares of the strains, 1e-7
}

TEST_CASE("stress is not smoothed across the surface between two materials") {
  Model model = irregular_box(linear_law(0.3));
  model.materials.push_back(soft(1e6, 0.3));
  model.materials[1].model = MaterialModel::st_venant_kirchhoff;
  for (std::size_t t = 0; t < model.tets.size(); ++t) model.tet_material[t] = t % 12 < 6;
  const State state = displaced(model, [](const Vector3d& x) -> Vector3d { return {0.01 * x.x(), 0, 0}; });
  const RecoveredStress recovered(model, state);
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const Vector6d own = stresses_of(model, state, t, {Vector4d::Constant(0.25)}).front().stress;
    REQUIRE((recovered.at(t, Vector4d::Constant(0.25)) - own).norm() < 1e-9 * own.norm());
  }
}
