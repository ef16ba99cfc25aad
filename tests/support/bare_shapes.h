// Meshes of round shapes from a box of cells, for tests of meshes that are opened on their own.
#pragma once
#include <cmath>

#include "sim/mesh/mesh_generate.h"

namespace fascia::test {

/// From [-1, 1]^2 or ^3 to the disc or ball of radius 1.
template <class V>
V round(const V& p) {
  const double length = p.norm();
  return length > 0 ? V(p * (p.cwiseAbs().maxCoeff() / length)) : p;
}

inline TetMesh make_ball(double radius, int cells = 8) {
  TetMesh mesh = make_box(cells, cells, cells, {2, 2, 2});
  deform(mesh, [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(radius * round(Eigen::Vector3d(p - Eigen::Vector3d::Ones())));
  });
  return mesh;
}

/// Upright, on y = 0; `tip`: radius of its upper end over that of its foot; 1 is a cylinder.
inline TetMesh make_cone(double radius, double height, double tip = 0.02, int cells = 6, int layers = 10) {
  TetMesh mesh = make_box(cells, layers, cells, {2, 1, 2});
  deform(mesh, [&](const Eigen::Vector3d& p) {
    const Eigen::Vector2d disc = round(Eigen::Vector2d(p.x() - 1, p.z() - 1));
    const double r = radius * (1 + p.y() * (tip - 1));
    return Eigen::Vector3d(r * disc.x(), height * p.y(), r * disc.y());
  });
  return mesh;
}

/// `mesh` with another axis where y was: 0 x, 1 y, 2 z, by a cyclic permutation.
inline TetMesh turned(TetMesh mesh, int axis) {
  for (Eigen::Vector3d& p : mesh.positions) {
    const Eigen::Vector3d q = p;
    for (int k = 0; k < 3; ++k) p[(k + axis + 2) % 3] = q[k];
  }
  return mesh;
}

inline TetMesh scaled(TetMesh mesh, double factor) {
  for (Eigen::Vector3d& p : mesh.positions) p *= factor;
  return mesh;
}

/// Both meshes as one, the second one moved.
inline TetMesh together(TetMesh a, const TetMesh& b, const Eigen::Vector3d& by) {
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  for (const Eigen::Vector3d& p : b.positions) a.positions.push_back(p + by);
  for (Tet t : b.tets) {
    for (std::uint32_t& v : t) v += first;
    a.tets.push_back(t);
    a.regions.push_back(0);
  }
  return a;
}

}  // namespace fascia::test
