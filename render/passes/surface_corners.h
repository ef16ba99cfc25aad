// The surface's vertices split for shading: where the rest shape has a sharp edge, the triangles on either side get
// normals of their own. A corner is a vertex with the fan of triangles that share one normal. Independent of OpenGL.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fascia {

struct SurfaceCorners {
  std::vector<std::uint32_t> vertex;     // [corner_count] vertex in the positions buffer
  std::vector<std::uint32_t> fan_begin;  // [corner_count + 1] into fan, in triangles
  std::vector<std::uint32_t> fan;  // [2 * 3 * triangle_count] the other two vertices of each triangle, in its winding
  std::vector<std::uint32_t> indices;  // [3 * triangle_count] the triangles by corner
  std::vector<std::uint32_t> colors;   // [corner_count] or empty
  std::vector<Eigen::Vector4f> rest;   // [corner_count] rest position [m], w 1; or empty
};

/// `rest_positions` may be empty: then every vertex is one corner. `colors` [3 * triangle_count], of the triangles'
/// corners, may be empty; a vertex with different colors has a corner for each, all with the same normal. Throws Error
/// for an index beyond vertex_count.
SurfaceCorners make_surface_corners(std::span<const std::array<std::uint32_t, 3>> triangles, std::uint32_t vertex_count,
                                    std::span<const Eigen::Vector3d> rest_positions,
                                    std::span<const std::uint32_t> colors = {});

}  // namespace fascia
