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
      Row{0.3, {1.2223, 1.2293, 4.4229, 6.1690, 6.2043, 7.9584}, {1.2315, 1.2315, 4.5207, 6.2363, 6.2363, 7.9558}},
      Row{0.49, {1.2430, 1.2511, 4.1337, 6.1177, 6.1527, 8.0703}, {1.2496, 1.2496, 4.2257, 6.1785, 6.1785, 8.0597}});
  const VectorXd found = natural_frequencies(beam(row.nu), 6);
  CAPTURE(row.nu, found.transpose());
  for (int k = 0; k < 6; ++k) CHECK(found[k] == Approx(row.same[static_cast<std::size_t>(k)]).margin(6e-5));
  for (const int k : {0, 1, 5}) CHECK(found[k] == Approx(row.continuum[static_cast<std::size_t>(k)]).epsilon(0.01));
  // Torsion and the second bending, which lumped masses slow down
  for (const int k : {2, 3, 4}) CHECK(found[k] == Approx(row.continuum[static_cast<std::size_t>(k)]).epsilon(0.025));
}

TEST_CASE("a body without supports has no frequencies to report") {
  CHECK(natural_frequencies(box_model(1, 1, 1, {1, 1, 1}, soft(1e5)), 3).size() == 0);
}
