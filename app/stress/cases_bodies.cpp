// Cases of tissue against tissue: cubes that collide fast, and rings caught in each other.
#include <numbers>

#include "app/stress/case_maker.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kSide = 0.1;                       // of a cube [m]
constexpr double kRing = 0.05, kThickness = 0.012;  // radius of the middle of a ring, side of its square section [m]

// A bar that is bent until its ends meet.
TetMesh ring(int around, int across) {
  const TetMesh bar = make_box(around, across, across, {1, kThickness, kThickness});
  TetMesh mesh;
  std::vector<std::uint32_t> place;
  for (const Vector3d& x : bar.positions) {
    const bool last = x.x() > 1 - 1e-9;
    std::uint32_t first = 0;  // where the bar begins, with the same place in its section
    while (last && (bar.positions[first] - Vector3d(0, x.y(), x.z())).norm() > 1e-9) ++first;
    place.push_back(last ? place[first] : static_cast<std::uint32_t>(mesh.positions.size()));
    if (last) continue;
    const double angle = 2 * std::numbers::pi * x.x(), radius = kRing - 0.5 * kThickness + x.y();
    mesh.positions.push_back({radius * std::cos(angle), radius * std::sin(angle), x.z() - 0.5 * kThickness});
  }
  for (Tet t : bar.tets) {
    for (std::uint32_t& v : t) v = place[v];
    if (signed_volume6(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]], mesh.positions[t[3]]) < 0)
      std::swap(t[2], t[3]);
    mesh.tets.push_back(t);
  }
  return mesh;
}

// Two bodies of one mesh.
Scene two(StressCases& c, const std::string& name, const TetMesh& mesh, double young) {
  Scene s = c.scene(name, mesh, false);
  s.bodies[0].material.young_modulus = young;
  s.bodies[0].material.model = kTissueLaw;
  s.bodies[0].material.damping = 0.01;
  s.bodies.push_back(s.bodies[0]);
  s.bodies[0].name = "first";
  s.bodies[1].name = "second";
  s.tools.contact.bodies = true;
  return s;
}

}  // namespace

void add_bodies(StressCases& c) {
  if (!info_of(c.pair.method).carries_contact || !carries(c.pair.method, kTissueLaw)) return;
  for (const double speed : {1.0, 3.0, 10.0})
    for (const double young : {1e4, 1e6}) {
      const int cells = c.quick ? 3 : 5;
      Scene s = two(c, "colliding_cube", make_box(cells, cells, cells, {kSide, kSide, kSide}), young);
      s.bodies[1].transform.translate = {kSide + 0.01, 0.03, 0.02};
      s.bodies[0].initial_velocity = Vector3d(0.5 * speed, 0, 0);
      s.bodies[1].initial_velocity = Vector3d(-0.5 * speed, 0, 0);
      StressCase& made =
          c.add("contact", "cubes at " + in_short(speed) + " m/s E=" + in_short(young), s, std::nullopt, 60);
      made.criteria.stays_apart = true;
      made.criteria.farthest = 60;
    }
  for (const double young : {1e4, 1e5}) {
    Scene s = two(c, "ring", ring(c.quick ? 20 : 40, c.quick ? 2 : 3), young);
    s.gravity = {0, -9.81, 0};
    s.bodies[0].fixed.push_back(BoxSelection{{-0.01, kRing - kThickness, -1}, {0.01, 1, 1}});
    s.bodies[1].transform.rotate_deg = {0, 90, 0};
    s.bodies[1].transform.translate = {0, -kRing, 0};
    StressCase& made = c.add("contact", "rings E=" + in_short(young), s, std::nullopt, 120);
    made.criteria.stays_apart = true;
    made.criteria.farthest = 1;
  }
}

}  // namespace fascia
