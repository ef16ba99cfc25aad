// The model of the coarse space: quadratic tets as linear ones.
#include <catch2/catch.hpp>

#include "sim/coarse/linear_model.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("the coarse space sees quadratic tets as linear ones of the same materials, over the same vertices") {
  Model model = quadratic(make_model(make_box(2, 2, 2, {0.2, 0.2, 0.2}), Material(),
                                     [](const Eigen::Vector3d& x) { return x.x() < 1e-9; }));
  model.materials.push_back(Material());
  for (std::size_t t = 0; t < model.tets.size(); ++t) model.tet_material[t] = t % 2;
  const Model linear = linear_model(model);
  REQUIRE(linear.tets.size() == 8 * model.tets.size());
  CHECK(linear.mid_edges.empty());
  CHECK(linear.held() == model.held());
  double mass = 0, expected = 0;
  for (const double m : lumped_masses(linear)) mass += m;
  for (const double m : lumped_masses(model)) expected += m;
  CHECK(mass == Approx(expected).epsilon(1e-12));
  for (std::size_t t = 0; t < linear.tets.size(); ++t) CHECK(linear.tet_material[t] == t / 8 % 2);
}
