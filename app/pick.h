// What lies under the mouse: a ray against the surface as it is deformed now.
#pragma once
#include <optional>
#include <span>

#include "render/camera.h"
#include "sim/tet_mesh.h"

namespace fascia {

struct Hit {
  std::size_t triangle;
  Eigen::Vector3d point;  // [m]
};

/// The first triangle that the ray meets, from either side.
std::optional<Hit> pick(const Ray& ray, std::span<const Triangle> triangles, std::span<const Eigen::Vector3d> positions);

/// The surface point nearest to the ray, which may miss the surface by any distance; nothing without triangles.
std::optional<Hit> pick_nearest(const Ray& ray, std::span<const Triangle> triangles, std::span<const Eigen::Vector3d> positions);

}  // namespace fascia
