#include "sim/bare_mesh/stiffness.h"

#include <catch2/catch.hpp>

#include "tests/support/bare_shapes.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr double kGravity = 10;

HeldBody standing(const TetMesh& mesh) {
  HeldBody body{mesh.positions, mesh.tets, {}};
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    if (mesh.positions[v].y() == 0) body.fixed.push_back(v);
  return body;
}

Material without_lateral_strain() {
  Material material;
  material.poisson_ratio = 0;
  return material;
}

WeightResponse response_of(const TetMesh& mesh) {
  return weight_response(standing(mesh), without_lateral_strain(), kGravity);
}

}  // namespace

TEST_CASE("a column without lateral strain shortens by rho g h^2 / 2 E") {
  const WeightResponse r = response_of(make_box(2, 40, 2, {0.05, 0.2, 0.05}));
  const double weight = 1000 * kGravity * 0.2;  // rho g h [Pa]
  INFO(r.strain << ' ' << r.peak << ' ' << r.sag);
  CHECK(r.sag == Approx(weight / 2).epsilon(0.02));  // the tets of a cell are not symmetric
  CHECK(r.strain == Approx(weight).epsilon(0.03));
  CHECK(r.peak == Approx(weight).epsilon(0.03));
}

TEST_CASE("the sway of a slender column is that of a beam, which buckles where it is one") {
  const double h = 0.4, w = 0.05;
  const WeightResponse r = response_of(make_box(6, 48, 6, {w, h, w}));
  const double beam = 1.5 * 1000 * kGravity * h * h * h / (w * w);  // (q h^4 / 8 E I) / h
  INFO(r.sway << " against " << beam);
  CHECK(r.sway > 0.8 * beam);  // linear tets are too stiff in bending
  CHECK(r.sway < 1.1 * beam);
}

TEST_CASE("a modulus of two digits keeps every limit") {
  CHECK(modulus_for({1000, 1000, 500, 500}) == Approx(20'000));
  CHECK(modulus_for({100, 1000, 500, 50'000}) == Approx(200'000));
  CHECK(modulus_for({100, 6100, 50, 50}) == Approx(20'000));  // 20,333
  CHECK(modulus_for({1e-9, 1e-9, 0, 0}) == Approx(1e-3));     // the least modulus
}

TEST_CASE("the response does not depend on the unit of mass and grows with the density") {
  const TetMesh cone = make_cone(0.05, 0.15);
  Material heavy;
  heavy.density = 2000;
  const WeightResponse light = weight_response(standing(cone), Material(), kGravity),
                       twice = weight_response(standing(cone), heavy, kGravity);
  CHECK(twice.strain == Approx(2 * light.strain));
  CHECK(twice.sway == Approx(2 * light.sway));
}

TEST_CASE("a body that is held everywhere, or nowhere, or only in a part, has the response of a column") {
  const TetMesh cube = make_box(1, 1, 1, {0.1, 0.1, 0.1});
  HeldBody body = standing(cube);
  body.fixed = {0, 1, 2, 3, 4, 5, 6, 7};
  CHECK(weight_response(body, Material(), kGravity).strain == Approx(1000));
  body.fixed.clear();
  const WeightResponse free = weight_response(body, Material(), kGravity);
  CHECK(std::max({free.strain, free.peak, free.sag, free.sway}) == Approx(1000));
  TetMesh pair = cube;
  for (const Eigen::Vector3d& x : cube.positions) pair.positions.emplace_back(x + Eigen::Vector3d(0.2, 0, 0));
  for (Tet t : cube.tets) {
    for (std::uint32_t& v : t) v += 8;
    pair.tets.push_back(t);
  }
  const WeightResponse half = weight_response({pair.positions, pair.tets, {0, 1, 2, 3}}, Material(), kGravity);
  CHECK(std::max({half.strain, half.peak, half.sag, half.sway}) == Approx(1000));
}

TEST_CASE("a coarser copy stands for a large mesh") {
  const TetMesh fine = make_box(16, 24, 16, {0.1, 0.15, 0.1}), coarse = make_box(8, 12, 8, {0.1, 0.15, 0.1});
  REQUIRE(fine.tets.size() > 30'000);
  const WeightResponse copy = weight_response(standing(fine), Material(), kGravity),
                       exact = weight_response(standing(coarse), Material(), kGravity);
  CHECK(copy.sag == Approx(exact.sag).epsilon(0.15));
  CHECK(copy.strain == Approx(exact.strain).epsilon(0.3));
  CHECK(copy.sway == Approx(exact.sway).epsilon(0.15));
}
