#include "sim/accuracy/frequencies.h"

#include <catch2/catch.hpp>

#include "tests/sim/reference/box_model.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// The beam of 1 x 0.25 x 0.25 m that is held at x = 0, 1,225 vertices.
Model beam(double nu) {
  Material material = soft(1e6, nu);
  material.model = MaterialModel::st_venant_kirchhoff;
  return quadratic(box_model(12, 3, 3, {1, 0.25, 0.25}, material, [](const Vector3d& x) { return x.x() == 0; }));
}

}  // namespace

TEST_CASE("a beam of quadratic tets has the frequencies of the continuum", "[quadratic]") {
  struct Row {
    double nu;
    std::vector<double> same, continuum;  // [Hz] of the same elements by another program; app/verify/cantilever.cpp
  };
  const Row row = GENERATE(
      Row{0.3, {1.2242, 1.2304, 4.5503, 6.2207, 6.2383, 7.9619}, {1.2315, 1.2315, 4.5207, 6.2363, 6.2363, 7.9558}},
      Row{0.49, {1.2450, 1.2523, 4.2526, 6.1683, 6.1864, 8.0751}, {1.2496, 1.2496, 4.2257, 6.1785, 6.1785, 8.0597}});
  const VectorXd found = natural_frequencies(beam(row.nu), 6);
  CAPTURE(row.nu, found.transpose());
  for (int k = 0; k < 6; ++k) CHECK(found[k] == Approx(row.same[static_cast<std::size_t>(k)]).margin(6e-5));
  for (int k = 0; k < 6; ++k) CHECK(found[k] == Approx(row.continuum[static_cast<std::size_t>(k)]).epsilon(0.01));
}

TEST_CASE("a body without supports has no frequencies to report") {
  CHECK(natural_frequencies(box_model(1, 1, 1, {1, 1, 1}, soft(1e5)), 3).size() == 0);
}
