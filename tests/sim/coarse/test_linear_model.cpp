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

TEST_CASE("the coarse space sees a K of ten mu where quadratic tets have a larger one, and the K of linear tets") {
  const MaterialModel law = GENERATE(MaterialModel::squared, MaterialModel::st_venant_kirchhoff);
  Model model =
      make_model(make_box(2, 2, 2, {0.2, 0.2, 0.2}), Material(), [](const Eigen::Vector3d&) { return false; });
  model.materials = {{1e5, 0.45, 1000, 0, law}, {1e5, 0.499, 1000, 0, law}};
  for (std::size_t t = 0; t < model.tets.size(); ++t) model.tet_material[t] = t % 2;
  CHECK_FALSE(has_large_bulk(model));
  model = quadratic(model, 24);
  CHECK(has_large_bulk(model));
  const Model linear = linear_model(model, true);
  for (std::size_t t = 0; t < linear.tets.size(); ++t) {
    const Material& seen = linear.materials[linear.tet_material[t]];
    const std::size_t source = t < 24 ? t : 24 + (t - 24) / 8;
    const Material& own = model.materials[model.tet_material[source]];
    CHECK(seen.lame_mu() == Approx(own.lame_mu()));
    const double pointwise = law == MaterialModel::squared ? 2.0 / 3 * own.lame_mu() : 0;
    const double expected =
        model.is_quadratic(source) ? std::min(own.lame_lambda(), pointwise + 10 * own.lame_mu()) : own.lame_lambda();
    CHECK(seen.lame_lambda() == Approx(expected));
  }
  for (std::size_t t = 0; t < model.tets.size(); ++t) model.tet_material[t] = 0;
  CHECK_FALSE(has_large_bulk(model));
}
