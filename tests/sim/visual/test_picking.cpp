// Picking against an independent brute-force method: the surface sampled densely, on a mesh that is bent and twisted.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "sim/mesh/mesh_generate.h"
#include "sim/mesh/tet_faces.h"
#include "sim/visual/picking.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

struct Deformed {
  TetMesh mesh = make_box(6, 3, 2, {0.6, 0.3, 0.2});
  std::vector<Triangle> triangles = boundary_triangles(mesh.tets);
  Deformed() {
    deform(mesh, [](const Vector3d& x) {
      const double angle = 2 * x.x();
      return Vector3d(x.x() + 0.05 * std::sin(9 * x.y()),
                      std::cos(angle) * x.y() - std::sin(angle) * x.z() - x.x() * x.x(),
                      std::sin(angle) * x.y() + std::cos(angle) * x.z());
    });
  }
};

Ray towards(const Vector3d& eye, const Vector3d& point) { return {eye, (point - eye).normalized()}; }

// Whether the ray passes through the triangle, by the signs of three volumes instead of barycentric coordinates.
bool passes(const Ray& ray, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d far = ray.origin + ray.direction;
  const double ab = signed_volume6(ray.origin, far, a, b), bc = signed_volume6(ray.origin, far, b, c),
               ca = signed_volume6(ray.origin, far, c, a);
  return (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
}

}  // namespace

TEST_CASE("the first triangle along the ray is hit, on a deformed surface") {
  const Deformed d;
  const auto& p = d.mesh.positions;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-0.6, 0.9);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector3d eye(2 * uniform(random), 2 * uniform(random), 1.5 + uniform(random));
    const Ray ray = towards(eye, {uniform(random), uniform(random), uniform(random)});
    double nearest = 1e300;
    for (const Triangle& t : d.triangles) {
      if (!passes(ray, p[t[0]], p[t[1]], p[t[2]])) continue;
      const Vector3d normal = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
      const double along = (p[t[0]] - eye).dot(normal) / ray.direction.dot(normal);
      if (along > 0) nearest = std::min(nearest, along);
    }
    const auto hit = pick(ray, d.triangles, p);
    CAPTURE(i, nearest);
    REQUIRE(hit.has_value() == (nearest < 1e300));
    if (!hit) continue;
    ++hits;
    CHECK((hit->point - eye).norm() == Approx(nearest).epsilon(1e-9));
    const Triangle& t = d.triangles[hit->triangle];
    CHECK(passes(ray, p[t[0]], p[t[1]], p[t[2]]));
  }
  CHECK(hits > 100);  // both outcomes occur
  CHECK(hits < 1900);
}

TEST_CASE("a ray that misses finds the nearest surface point") {
  const Deformed d;
  const auto& p = d.mesh.positions;
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int misses = 0;
  for (int i = 0; i < 100; ++i) {
    const Ray ray =
        towards({0.3 + uniform(random), uniform(random), 2}, {0.3 + 2 * uniform(random), 2 * uniform(random), 0});
    const auto across = [&](const Vector3d& x) {
      return (x - ray.origin - ray.direction * ray.direction.dot(x - ray.origin)).norm();
    };
    const auto hit = pick_nearest(ray, d.triangles, p);
    REQUIRE(hit);
    if (pick(ray, d.triangles, p)) {
      CHECK(across(hit->point) < 1e-12);
      continue;
    }
    ++misses;
    double sampled = 1e300;  // over points of all edges, where the minimum for a missed triangle is
    for (const Triangle& t : d.triangles)
      for (int k = 0; k < 3; ++k)
        for (int s = 0; s <= 200; ++s)
          sampled = std::min(sampled, across(p[t[k]] + (p[t[(k + 1) % 3]] - p[t[k]]) * (s / 200.0)));
    CAPTURE(i, sampled, across(hit->point));
    CHECK(across(hit->point) <= sampled + 1e-12);
    CHECK(across(hit->point) >= sampled - 1e-3);  // the samples are at most 1e-3 m apart
    const Triangle& t = d.triangles[hit->triangle];
    const Vector3d normal = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).normalized();
    CHECK(std::abs(normal.dot(hit->point - p[t[0]])) < 1e-12);
  }
  CHECK(misses > 10);
}

TEST_CASE("on a body that is cut open the part beyond is not hit, and the cut is") {
  const TetMesh box = make_box(4, 4, 4, {1, 1, 1});
  const std::vector<Triangle> triangles = boundary_triangles(box.tets);
  const auto& p = box.positions;
  const Cut cut = SectionCut{{0, 0, 1}, 0.4f};
  const double plane = 0.4f;
  const auto on_cut = pick(towards({0.3, 0.6, 3}, {0.35, 0.55, 0}), triangles, p, cut);
  REQUIRE(on_cut);
  CHECK(on_cut->on_cut);
  CHECK(on_cut->point.z() == Approx(plane));
  CHECK(on_cut->normal == Vector3d(0, 0, 1));
  // Past the edge of the cut, into a side wall of the remaining part.
  const auto wall = pick(towards({3, 0.5, 1}, {1, 0.5, 0.2}), triangles, p, cut);
  REQUIRE(wall);
  CHECK_FALSE(wall->on_cut);
  CHECK(wall->point.isApprox(Vector3d(1, 0.5, 0.2)));
  CHECK(wall->normal.isApprox(Vector3d(1, 0, 0)));
  CHECK_FALSE(pick(towards({3, 0.5, 0.7}, {1, 0.5, 0.7}), triangles, p, cut));  // through the removed part
  // From the remaining side nothing changes.
  CHECK(pick(towards({0.3, 0.6, -3}, {0.3, 0.6, 0}), triangles, p, cut)->point.isApprox(Vector3d(0.3, 0.6, 0)));
  CHECK_FALSE(pick(towards({0.5, 0.5, 0.2}, {0.5, 0.5, 1}), triangles, p, cut));  // out through the cut
  const auto near = pick_nearest(towards({3, 0.5, 0.9}, {0, 0.5, 0.9}), triangles, p, cut);
  REQUIRE(near);
  CHECK(near->point.z() <= plane);
}

TEST_CASE("rays without a target hit nothing") {
  const Deformed d;
  CHECK_FALSE(pick(towards({0, 0, 2}, {0, 0, 3}), d.triangles, d.mesh.positions));  // the body is behind the eye
  CHECK_FALSE(pick_nearest(towards({0, 0, 2}, {0, 0, 3}), d.triangles, d.mesh.positions));
  CHECK_FALSE(pick_nearest(towards({0, 0, 2}, {0, 0, 0}), {}, d.mesh.positions));
  const std::vector<Vector3d> flat = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};  // a triangle without area
  const std::vector<Triangle> sliver = {{0, 1, 2}};
  CHECK_FALSE(pick(towards({1, 0, 2}, {1, 0, 0}), sliver, flat));
  const auto near = pick_nearest(towards({1, 0, 2}, {1, 0.1, 0}), sliver, flat);
  REQUIRE(near);
  CHECK(near->point.isApprox(Vector3d(1, 0, 0)));
}
