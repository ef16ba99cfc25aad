// Signed distances of rigid shapes, exact outside, and inside up to the nearest face; of meshes as of
// sim/tool/solid_mesh.h.
#pragma once
#include <Eigen/Core>

#include "sim/scene/tools/scene_tools.h"

namespace fascia {

struct ShapeDistance {
  double distance = 0;              // [m] negative inside
  Eigen::Vector3d normal{0, 0, 0};  // its gradient, a unit vector apart from meshes, whose is about one
  Eigen::Matrix3d curvature;        // its Hessian [1/m]
};
/// At a point in the axes of the shape [m].
ShapeDistance distance_to(const ToolShape& shape, const Eigen::Vector3d& point);
/// The distance for reports [m]: that of distance_to(), which far from a mesh is a lower bound only, exact there, too.
double gap_to(const ToolShape& shape, const Eigen::Vector3d& point);

/// The radius [m] of the finest part of a shape that may press into tissue; infinite for a plane.
double finest_radius(const ToolShape& shape);
/// The radius [m] of the sharpest edge between flat faces, or of a rim; infinite without one. Meshes have none.
double sharpest_edge(const ToolShape& shape);
/// Whether a point in the axes of the shape is within about `width` [m] of such an edge, inside or outside.
bool near_edge(const ToolShape& shape, const Eigen::Vector3d& point, double width);
/// Middle of the shape, and the radius [m] of a ball around it that contains the shape; infinite for a plane.
Eigen::Vector3d middle_of(const ToolShape& shape);
double bounding_radius(const ToolShape& shape);

}  // namespace fascia
