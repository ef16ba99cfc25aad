// The shapes of rigid pieces as shaders/sim/contact/piece.glsl reads them.
#pragma once
#include <set>

#include "sim/gpu/passes/energy_term.h"
#include "sim/tool/tool.h"

namespace fascia {

/// A vector and a number as a row of a buffer.
shared::vec4 row_of(const Eigen::Vector3d& v, double w = 0);

struct PieceRows {
  int kind;
  shared::vec4 a, b;
};
/// `first_node`: of the grid of a mesh, in the buffer of all grids.
PieceRows piece_rows_of(const ToolShape& shape, std::size_t first_node = 0);

/// Of kernels that compute distances to these kinds of shapes.
gl::Defines defines_of_shapes(const std::set<int>& kinds);

}  // namespace fascia
