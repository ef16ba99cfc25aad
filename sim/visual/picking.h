// What lies under the mouse: a ray against the surface as it is deformed now, cut open where a section plane is shown.
#pragma once
#include <optional>
#include <span>

#include "base/ray.h"
#include "sim/mesh/tet_mesh.h"

namespace fascia {

struct Hit {
  std::size_t triangle;    // of a hit on the cut: the first one behind it
  Eigen::Vector3d point;   // [m]
  Eigen::Vector3d normal;  // of the triangle or the cut, outward, unit length; zero for a triangle without area
  bool on_cut = false;
};

/// What lies beyond the plane of `cut` is not there; the cut itself is met where the triangles enclose it.
using Cut = std::optional<SectionCut>;

/// The first triangle that the ray meets, from either side.
std::optional<Hit> pick(const Ray& ray, std::span<const Triangle> triangles, std::span<const Eigen::Vector3d> positions,
                        const Cut& cut = {});

/// The surface point nearest to the ray, which may miss the surface by any distance; nothing without triangles.
std::optional<Hit> pick_nearest(const Ray& ray, std::span<const Triangle> triangles,
                                std::span<const Eigen::Vector3d> positions, const Cut& cut = {});

}  // namespace fascia
