#include "sim/accuracy/rigid_motions.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <utility>

#include "sim/mesh/pieces.h"

namespace fascia {

using Eigen::Vector3d;

std::vector<std::vector<std::uint32_t>> free_pieces(const std::vector<Tet>& tets, const std::vector<char>& held) {
  const std::vector<std::uint32_t> piece = pieces_of(tets, held.size());
  std::vector<std::vector<std::uint32_t>> vertices(held.size());
  std::vector<char> used(held.size()), bound(held.size());
  for (const Tet& tet : tets)
    for (const std::uint32_t v : tet) used[v] = 1;
  for (std::uint32_t v = 0; v < held.size(); ++v) {
    if (used[v]) vertices[piece[v]].push_back(v);
    if (held[v]) bound[piece[v]] = 1;
  }
  std::vector<std::vector<std::uint32_t>> free;
  for (std::size_t p = 0; p < vertices.size(); ++p)
    if (!bound[p] && !vertices[p].empty()) free.push_back(std::move(vertices[p]));
  return free;
}

std::vector<Vector3d> deformation(const std::vector<Vector3d>& rest, const std::vector<Vector3d>& now) {
  Eigen::Matrix3Xd from(3, rest.size()), to(3, rest.size());
  for (std::size_t v = 0; v < rest.size(); ++v) {
    from.col(static_cast<Eigen::Index>(v)) = rest[v];
    to.col(static_cast<Eigen::Index>(v)) = now[v];
  }
  const Eigen::Matrix4d rigid = Eigen::umeyama(from, to, false);
  std::vector<Vector3d> left;
  for (std::size_t v = 0; v < rest.size(); ++v) left.emplace_back(now[v] - (rigid * rest[v].homogeneous()).head<3>());
  return left;
}

void RigidMotions::add(const std::vector<std::uint32_t>& vertices, const std::vector<Vector3d>& places) {
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& x : places) middle += x / static_cast<double>(places.size());
  double size = 0;
  for (const Vector3d& x : places) size = std::max(size, (x - middle).norm());
  Eigen::Matrix<double, Eigen::Dynamic, 6> motions(3 * places.size(), 6);
  for (std::size_t v = 0; v < places.size(); ++v)
    for (int axis = 0; axis < 3; ++axis) {
      const auto row = static_cast<Eigen::Index>(3 * v);
      motions.block<3, 1>(row, axis) = Vector3d::Unit(axis);
      motions.block<3, 1>(row, 3 + axis) = Vector3d::Unit(axis).cross(places[v] - middle) / size;
    }
  const Eigen::HouseholderQR<Eigen::MatrixXd> factors(motions);
  sets_.push_back({vertices, factors.householderQ() * Eigen::MatrixXd::Identity(motions.rows(), 6)});
}

void RigidMotions::remove_from(std::vector<Vector3d>& vectors) const {
  for (const Set& set : sets_) {
    Eigen::VectorXd all(3 * set.vertices.size());
    for (std::size_t v = 0; v < set.vertices.size(); ++v)
      all.segment<3>(static_cast<Eigen::Index>(3 * v)) = vectors[set.vertices[v]];
    all -= set.motions * (set.motions.transpose() * all);
    for (std::size_t v = 0; v < set.vertices.size(); ++v)
      vectors[set.vertices[v]] = all.segment<3>(static_cast<Eigen::Index>(3 * v));
  }
}

}  // namespace fascia
