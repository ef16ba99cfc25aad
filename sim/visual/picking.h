// Finds what is under the mouse: intersects a ray with the currently deformed surface, cut open by the shown section
// plane.
#pragma once
#include <optional>
#include <span>

#include "base/ray.h"
#include "sim/mesh/tet_mesh.h"

namespace fascia {

struct Hit {
  std::size_t triangle;    // for a hit on the cut: the first one behind it
  Eigen::Vector3d point;   // [m]
  Eigen::Vector3d normal;  // of the triangle or the cut, outward, unit length; zero for a triangle without area
  bool on_cut = false;
};

/// The part beyond the plane of `cut` is invisible; the cut itself is hit where the triangles enclose it.
using Cut = std::optional<SectionCut>;

/// The first triangle that the ray hits, from either side.
std::optional<Hit> pick(const Ray& ray, std::span<const Triangle> triangles, std::span<const Eigen::Vector3d> positions,
                        const Cut& cut = {});

/// The surface point nearest to the ray, which may miss the surface by any distance; none without triangles.
std::optional<Hit> pick_nearest(const Ray& ray, std::span<const Triangle> triangles,
                                std::span<const Eigen::Vector3d> positions, const Cut& cut = {});

}  // namespace fascia
