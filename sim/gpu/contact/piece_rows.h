// The shapes of rigid pieces as shaders/sim/contact/piece.glsl reads them.
#pragma once
#include <set>

#include "sim/gpu/passes/energy_term.h"
#include "sim/tool/tool.h"

namespace fascia {

/// What float32 loses of it.
Eigen::Vector3d rounding_of(const Eigen::Vector3d& v);
/// A vector and a number as a row of a buffer.
shared::vec4 row_of(const Eigen::Vector3d& v, double w = 0);

struct PieceRows {
  int kind;
  shared::vec4 a, b;
  Eigen::Vector3d lost_place{0, 0, 0}, lost_half{0, 0, 0};  // roundings in its axes [m]; half: half sizes of a box
  double lost_radius = 0;
  double round = 0;  // of a cylinder [m]; a and b are those of its core
};
/// `first_node`: of the grid of a mesh, in the buffer of all grids.
PieceRows piece_rows_of(const ToolShape& shape, std::size_t first_node = 0);

/// Of kernels that compute distances to these kinds of shapes.
gl::Defines defines_of_shapes(const std::set<int>& kinds);

}  // namespace fascia
