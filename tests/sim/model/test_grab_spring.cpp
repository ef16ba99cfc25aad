// Springs of grabs: several at a vertex act as one, and each grab has its share of the force.
#include "sim/model/grab_spring.h"

#include <catch2/catch.hpp>

using namespace fascia;
using Eigen::Vector3d;

TEST_CASE("springs at one vertex are joined without a change of their forces") {
  const std::vector<GrabSpring> springs{
      {3, {1, 0, 0}, 2, 0}, {5, {0, 0, 1}, 1, 0}, {3, {0, 2, 0}, 6, 1}, {7, {1, 1, 1}, 4, 1}};
  std::vector<std::uint32_t> place;
  const std::vector<GrabSpring> whole = joined(springs, place);
  REQUIRE(whole.size() == 3);
  CHECK(place == std::vector<std::uint32_t>{0, 1, 0, 2});
  CHECK(whole[0].stiffness == 8);
  CHECK((whole[0].target - Vector3d(0.25, 1.5, 0)).norm() < 1e-15);
  CHECK(whole[1] == springs[1]);
  std::vector<Vector3d> u(8, Vector3d(0.3, -0.2, 0.1)), forces;
  for (const GrabSpring& s : whole) forces.push_back(s.stiffness * (s.target - u[s.vertex]));
  const std::vector<GrabForce> exact = forces_of_grabs(springs, u),
                               split = forces_of_grabs(springs, whole, place, forces);
  REQUIRE(exact.size() == 2);
  REQUIRE(split.size() == 2);
  Vector3d sum(0, 0, 0);
  for (std::size_t h = 0; h < 2; ++h) {
    CHECK(split[h].grab == exact[h].grab);
    CHECK((split[h].force - exact[h].force).norm() < 1e-12);
    sum += split[h].force;
  }
  CHECK((sum - forces[0] - forces[1] - forces[2]).norm() < 1e-12);
}

TEST_CASE("springs without stiffness, alone or beside others, change nothing and have no force") {
  const std::vector<GrabSpring> springs{
      {2, {1, 2, 3}, 0, 4}, {2, {5, 5, 5}, 0, 5}, {1, {1, 0, 0}, 3, 4}, {1, {9, 9, 9}, 0, 5}};
  std::vector<std::uint32_t> place{7, 7, 7};  // left over from another call
  const std::vector<GrabSpring> whole = joined(springs, place);
  CHECK(place == std::vector<std::uint32_t>{0, 0, 1, 1});
  REQUIRE(whole.size() == 2);
  CHECK(whole[0] == springs[0]);
  CHECK(whole[1] == springs[2]);
  const std::vector<GrabForce> forces = forces_of_grabs(springs, whole, place, {{0, 0, 0}, {3, 0, 0}});
  REQUIRE(forces.size() == 2);
  CHECK(forces[0].grab == 4);
  CHECK(forces[0].force == Vector3d(3, 0, 0));
  CHECK(forces[1].grab == 5);
  CHECK(forces[1].force == Vector3d(0, 0, 0));
  CHECK(forces_of_grabs({}, {{0, 0, 0}}).empty());
}
