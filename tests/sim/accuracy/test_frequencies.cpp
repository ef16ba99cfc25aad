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
  const Row row = GENERATE(Row{0.3,
                               {1.22439, 1.23052, 4.54964, 6.21107, 6.23271, 7.96036},
                               {1.2315, 1.2315, 4.5207, 6.2363, 6.2363, 7.9558}},
                           Row{0.49,
                               {1.24516, 1.25233, 4.25209, 6.15846, 6.18295, 8.0722},
                               {1.2496, 1.2496, 4.2257, 6.1785, 6.1785, 8.0597}});
  const VectorXd found = natural_frequencies(beam(row.nu), 6);
  CAPTURE(row.nu, found.transpose());
  for (int k = 0; k < 6; ++k) CHECK(found[k] == Approx(row.same[static_cast<std::size_t>(k)]).margin(1e-5));
  for (int k = 0; k < 6; ++k) CHECK(found[k] == Approx(row.continuum[static_cast<std::size_t>(k)]).epsilon(0.01));
}

TEST_CASE("a body without supports has no frequencies to report") {
  CHECK(natural_frequencies(box_model(1, 1, 1, {1, 1, 1}, soft(1e5)), 3).size() == 0);
}
