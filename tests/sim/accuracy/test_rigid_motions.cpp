#include "sim/accuracy/rigid_motions.h"

#include <catch2/catch.hpp>

#include "tests/sim/reference/box_model.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST_CASE("the pieces that nothing holds are found, each with its vertices") {
  const std::vector<Tet> tets = {{0, 1, 2, 3}, {9, 8, 7, 6}, {4, 5, 10, 11}, {6, 7, 8, 12}};
  std::vector<char> held(14, 0);
  held[5] = 1;
  const std::vector<std::vector<std::uint32_t>> expected = {{0, 1, 2, 3}, {6, 7, 8, 9, 12}};
  CHECK(free_pieces(tets, held) == expected);
  held[12] = 1;
  CHECK(free_pieces(tets, held) == std::vector<std::vector<std::uint32_t>>{{0, 1, 2, 3}});
}

TEST_CASE("a rigid motion is no deformation, and what is added to it is found") {
  Random random(3);
  const Matrix3d turn = random.rotation();
  const Vector3d way = random.vector();
  std::vector<Vector3d> rest, now, bent;
  for (int v = 0; v < 30; ++v) {
    rest.push_back(random.vector());
    now.push_back(turn * rest.back() + way);
    bent.push_back(now.back() + 1e-3 * random.vector());
  }
  double rigid = 0, left = 0, added = 0;
  const std::vector<Vector3d> none = deformation(rest, now), some = deformation(rest, bent);
  for (std::size_t v = 0; v < rest.size(); ++v) {
    rigid += none[v].squaredNorm();
    left += some[v].squaredNorm();
    added += (bent[v] - now[v]).squaredNorm();
  }
  CHECK(rigid < 1e-24);
  CHECK(left <= added);
  CHECK(left > 0.8 * added);  // six of ninety directions are rigid
}

TEST_CASE("forces that rigid motions are taken out of have neither sum nor torque, and others stay") {
  Random random(4);
  std::vector<std::uint32_t> vertices;
  std::vector<Vector3d> places, forces(40);
  for (Vector3d& f : forces) f = random.vector();
  for (std::uint32_t v = 5; v < 35; ++v) {
    vertices.push_back(v);
    places.push_back(Vector3d(10, 0, 0) + random.vector());
  }
  RigidMotions rigid;
  rigid.add(vertices, places);
  const std::vector<Vector3d> before = forces;
  rigid.remove_from(forces);
  Vector3d sum = Vector3d::Zero(), torque = Vector3d::Zero();
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    sum += forces[vertices[k]];
    torque += places[k].cross(forces[vertices[k]]);
  }
  CHECK(sum.norm() < 1e-12);
  CHECK(torque.norm() < 1e-11);
  CHECK(forces[4] == before[4]);
  CHECK(forces[35] == before[35]);
  const std::vector<Vector3d> once = forces;
  rigid.remove_from(forces);
  for (std::size_t v = 0; v < forces.size(); ++v) CHECK((forces[v] - once[v]).norm() < 1e-12);
}
