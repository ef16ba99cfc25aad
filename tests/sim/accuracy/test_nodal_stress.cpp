#include "sim/accuracy/nodal_stress.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/accuracy/recovered_stress.h"
#include "tests/sim/reference/box_model.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using reference::Vector6d;

namespace {

Material of_green_strain(double young_modulus, double nu) {
  Material material = soft(young_modulus, nu);
  material.model = MaterialModel::st_venant_kirchhoff;
  return material;
}

Model box_of(bool ten_nodes, const Material& material) {
  const Model box = box_model(4, 3, 3, {0.4, 0.3, 0.3}, material);
  return ten_nodes ? quadratic(box) : box;
}

State moved(const Model& model, const std::function<Vector3d(const Vector3d&)>& u) {
  State state = initial_state(model);
  for (std::size_t v = 0; v < state.displacement.size(); ++v) state.displacement[v] = u(model.rest_positions[v]);
  return state;
}

}  // namespace

TEST_CASE("a uniform Cauchy stress is exact at every vertex of a stretched and turned body") {
  const bool ten_nodes = GENERATE(false, true);
  const Material material = of_green_strain(1e5, 0.4);
  const Model model = box_of(ten_nodes, material);
  const Matrix3d f = Random(5).rotation() * Vector3d(1.3, 0.8, 1.1).asDiagonal().toDenseMatrix();
  const NodalStress stress =
      nodal_stress(model, moved(model, [&](const Vector3d& x) -> Vector3d { return f * x - x; }));
  const Matrix3d exact = reference::first_piola_stress(f, material) * f.transpose() / f.determinant();
  REQUIRE(stress.cauchy.size() == model.rest_positions.size());
  double largest = 0;
  for (const Vector6d& s : stress.cauchy) largest = std::max(largest, (matrix_of(s) - exact).norm());
  CAPTURE(ten_nodes, largest, exact.norm());
  CHECK(largest < 1e-9 * exact.norm());
  for (const double value : stress.von_mises) REQUIRE(value == Approx(reference::von_mises(f, material)));
  const PeakStress peak = peak_of(stress, model);
  CHECK(peak.max == Approx(reference::von_mises(f, material)));
  CHECK(peak.p99 == Approx(reference::von_mises(f, material)));
}

// The same bending as in fascia verify, with the exact displacements: without lateral contraction the stress is E y.
TEST_CASE(
    "a stress that varies linearly is exact at the corners and mid-edges of quadratic tets, and nearer in linear "
    "ones") {
  static constexpr double kBend = 1e-6;
  const bool ten_nodes = GENERATE(false, true);
  const Model model = box_of(ten_nodes, of_green_strain(1e5, 0));
  const State state = moved(model, [](const Vector3d& x) -> Vector3d {
    return kBend * Vector3d(x.x() * (x.y() - 0.15), -0.5 * x.x() * x.x(), 0);
  });
  const NodalStress stress = nodal_stress(model, state);
  const auto exact_at = [](const Vector3d& x) { return 1e5 * kBend * std::abs(x.y() - 0.15); };
  const double outermost = 1e5 * kBend * 0.15;
  const PeakStress peak = peak_of(stress, model);
  CAPTURE(ten_nodes, peak.max / outermost, peak.p99 / outermost);
  CHECK(peak.max == *std::max_element(stress.von_mises.begin(), stress.von_mises.end()));
  CHECK(peak.p99 == exceeded_by_a_hundredth(stress.von_mises, vertex_volumes(model)));
  // Coarse: the vertices of the two outermost faces stand for more than 1 % of the volume.
  if (ten_nodes) CHECK(peak.max == Approx(outermost).epsilon(1e-4));
  if (ten_nodes) CHECK(peak.p99 == Approx(outermost).epsilon(1e-4));
  double recovered = 0,
         tets = 0;  // squared errors at the vertices of all tets, and those of the tets' own stress there
  const std::vector<double> of_tets = reference::export_fields(model, state).von_mises;
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (const std::uint32_t v : model.element(t)) {
      const double exact = exact_at(model.rest_positions[v]);
      if (ten_nodes) REQUIRE(std::abs(stress.von_mises[v] - exact) < 1e-4 * outermost);
      recovered += std::pow(stress.von_mises[v] - exact, 2);
      tets += std::pow(of_tets[t] - exact, 2);
    }
  CAPTURE(ten_nodes, std::sqrt(recovered / tets));
  CHECK(recovered < 0.25 * tets);
}

TEST_CASE("where materials meet a vertex has the stress of one of them, the larger one") {
  Model model = box_of(GENERATE(false, true), of_green_strain(1e5, 0));
  model.materials.push_back(of_green_strain(1e6, 0));
  // Halves along y, stretched alike: stresses of 1 : 10.
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    double low = 1;
    for (const std::uint32_t v : model.tets[t]) low = std::min(low, model.rest_positions[v].y());
    model.tet_material[t] = low > 0.09 ? 1 : 0;
  }
  const State state = moved(model, [](const Vector3d& x) -> Vector3d { return {0.01 * x.x(), 0, 0}; });
  const NodalStress stress = nodal_stress(model, state);
  const double soft_one = reference::von_mises(Vector3d(1.01, 1, 1).asDiagonal().toDenseMatrix(), model.materials[0]);
  for (std::size_t v = 0; v < stress.von_mises.size(); ++v) {
    CAPTURE(v, model.rest_positions[v].transpose());
    REQUIRE(stress.von_mises[v] == Approx(model.rest_positions[v].y() > 0.09 ? 10 * soft_one : soft_one));
  }
}

TEST_CASE("the stress of flat and of mirrored tets is finite, and a stopped computation has zeros") {
  const Model model = box_of(GENERATE(false, true), soft(1e5, 0.3));
  const State flat_one = moved(model,
                               [](const Vector3d&x) -> Vector3d {
                                 return {0, -x.y(), 0};
                               }),
              mirrored = moved(model, [](const Vector3d&x) -> Vector3d {
                return {0, -2 * x.y(), 0};
              });
  for (const State& state : {flat_one, mirrored})
    for (const double value : nodal_stress(model, state).von_mises) REQUIRE(std::isfinite(value));
  std::stop_source stop;
  stop.request_stop();
  CHECK(nodal_stress(model, mirrored, stop.get_token()).von_mises ==
        std::vector<double>(model.rest_positions.size(), 0));
}

TEST_CASE("a hundredth of the volume exceeds the percentile, whatever the order of the values") {
  std::vector<double> values, volumes;
  for (int k = 0; k < 1000; ++k) {
    values.push_back((k * 7919) % 1000);
    volumes.push_back(2);
  }
  CHECK(exceeded_by_a_hundredth(values, volumes) == 990);
  volumes[static_cast<std::size_t>(std::find(values.begin(), values.end(), 999.0) - values.begin())] = 100;
  CHECK(exceeded_by_a_hundredth(values, volumes) == 999);
  CHECK(exceeded_by_a_hundredth({}, {}) == 0);
  const Model model = box_of(GENERATE(false, true), soft(1e5));
  double sum = 0;
  for (const double volume : vertex_volumes(model)) sum += volume;
  CHECK(sum == Approx(0.4 * 0.3 * 0.3));
}

TEST_CASE("the peak of stresses that are not finite is unknown, that of no stress zero") {
  const Model model = box_of(false, soft(1e5));
  NodalStress stress = nodal_stress(model, initial_state(model));
  CHECK(peak_of(stress, model).max < 1e-9);
  stress.von_mises[3] = std::nan("");
  CHECK(std::isnan(peak_of(stress, model).max));
  CHECK(std::isnan(peak_of(stress, model).p99));
  CHECK(peak_of({}, Model()).max == 0);
  CHECK(peak_of({}, Model()).p99 == 0);
}

TEST_CASE("displacements that are rounded have less stress than that of rounding, and deformed ones have more") {
  const bool quadratic = GENERATE(false, true);
  Material material;
  material.young_modulus = 1e5;
  Model model = test::make_model(make_box(3, 2, 2, {0.3, 0.2, 0.2}), material, [](const Vector3d&) { return false; });
  if (quadratic) model = test::quadratic(model);
  for (const double distance : {0.1, 10.0}) {
    State state = initial_state(model);
    const auto move_by = [&](double stretch) {
      for (std::size_t v = 0; v < state.displacement.size(); ++v)
        state.displacement[v] = float32_of(distance * Vector3d(1, 0.3, -0.7) + stretch * model.rest_positions[v]);
    };
    move_by(0);
    for (std::size_t v = 0; v < state.displacement.size(); ++v)  // every other vertex is off by a last place
      if (v % 2 == 0) state.displacement[v] = float32_of((1 + 0x1p-23) * state.displacement[v]);
    const double rounded = peak_of(nodal_stress(model, state), model).p99, bound = stress_of_rounding(model, state);
    CAPTURE(quadratic, distance, rounded, bound);
    CHECK(rounded > 0);
    CHECK(rounded < bound);
    CHECK(peak_beyond_rounding(model, state) == 0);
    for (std::size_t v = 0; v < state.displacement.size(); ++v)
      state.displacement[v].x() += 0.01 * model.rest_positions[v].x();
    CHECK(peak_beyond_rounding(model, state) == peak_of(nodal_stress(model, state), model).p99);
    CHECK(peak_beyond_rounding(model, state) > 700);
  }
}
