// The body-centered cubic lattice of isosurface stuffing (sim/surface/isosurface_stuffing.h): points, cells, tets.
#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// Corners of cubic cells, and their centers. A tet joins the centers of two cells with an edge of the face between
/// them: two long edges (one spacing) and four short ones (0.87 spacings).
class BccLattice {
 public:
  BccLattice(const Eigen::AlignedBox3d& box, int cells) : spacing(box.sizes().maxCoeff() / cells) {
    for (int k = 0; k < 3; ++k) count[k] = static_cast<int>(std::ceil(box.sizes()[k] / spacing - 1e-9)) + 2;
    // Keeps lattice points off the planes where modeled surfaces often lie, since rounding would decide the side of
    // every point there.
    const Eigen::Vector3d shift(0.0031, 0.0047, 0.0059);
    origin = box.center() - spacing * (count.cast<double>() / 2 + shift);
    corner_count = static_cast<std::uint32_t>((count.x() + 1) * (count.y() + 1) * (count.z() + 1));
  }

  std::uint32_t corner(const Eigen::Vector3i& c) const {
    return static_cast<std::uint32_t>((c.x() * (count.y() + 1) + c.y()) * (count.z() + 1) + c.z());
  }
  std::uint32_t cell(const Eigen::Vector3i& c) const {
    return static_cast<std::uint32_t>((c.x() * count.y() + c.y()) * count.z() + c.z());
  }
  std::uint32_t center(const Eigen::Vector3i& c) const { return corner_count + cell(c); }
  std::uint32_t cell_count() const { return static_cast<std::uint32_t>(count.prod()); }
  std::uint32_t point_count() const { return corner_count + cell_count(); }
  bool is_center(std::uint32_t point) const { return point >= corner_count; }
  bool is_long(std::uint32_t a, std::uint32_t b) const { return is_center(a) == is_center(b); }

  Eigen::Vector3d position(std::uint32_t point) const {
    const bool centered = is_center(point);
    const Eigen::Vector3i n = centered ? count : Eigen::Vector3i(count.array() + 1);
    const auto index = static_cast<int>(centered ? point - corner_count : point);
    const Eigen::Vector3d at(index / (n.y() * n.z()), index / n.z() % n.y(), index % n.z());
    return origin + spacing * (centered ? Eigen::Vector3d(at.array() + 0.5) : at);
  }
  Eigen::Vector3i cell_at(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d at = ((p - origin) / spacing).array().floor();
    return at.cast<int>().cwiseMax(0).cwiseMin(Eigen::Vector3i(count.array() - 1));
  }

  template <class F>
  void for_cells(const Eigen::Vector3i& low, const Eigen::Vector3i& high, F f) const {
    for (int i = low.x(); i <= high.x(); ++i)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int k = low.z(); k <= high.z(); ++k) f(Eigen::Vector3i(i, j, k));
  }

  /// The tets around the face between a cell and the next one along an axis: f(tet, number), with ascending numbers
  /// over the lattice.
  template <class F>
  void for_tets_of_face(const Eigen::Vector3i& c, int axis, F f) const {
    const Eigen::Vector3i along = Eigen::Vector3i::Unit(axis), u = Eigen::Vector3i::Unit((axis + 1) % 3),
                          v = Eigen::Vector3i::Unit((axis + 2) % 3);
    const Eigen::Vector3i base = c + along;
    if (base[axis] >= count[axis]) return;
    const Eigen::Vector3i ring[4] = {base, base + u, base + u + v, base + v};
    for (int e = 0; e < 4; ++e)
      f(Tet{center(c), center(base), corner(ring[e]), corner(ring[(e + 1) % 4])},
        (std::size_t{cell(c)} * 3 + axis) * 4 + e);
  }
  template <class F>
  void for_tets(F f) const {
    for_cells(Eigen::Vector3i::Zero(), count.array() - 1, [&](const Eigen::Vector3i& c) {
      for (int axis = 0; axis < 3; ++axis) for_tets_of_face(c, axis, f);
    });
  }

  double spacing;
  Eigen::Vector3d origin;
  Eigen::Vector3i count;
  std::uint32_t corner_count;
};

}  // namespace fascia
