// An order of the tets along a space-filling curve: neighbors in space are close in memory for any order of the mesh
// file.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/model/model.h"
#include "sim/ordering/tet_pairing.h"

namespace fascia {

/// Tets sorted by the Morton code (1024 cells along the longest side of the bounding box) of their centroids; tets of
/// one cell keep their order. [tet_count] indices into `tets`.
std::vector<std::uint32_t> curve_order(const std::vector<Eigen::Vector3d>& positions, const std::vector<Tet>& tets);

/// The tets that a solver needs, along the curve: all except those with only fixed vertices, which never deform.
std::vector<std::uint32_t> solved_tets(const Model& model);
/// The same in pairs. The larger tet of a pair, which is the higher one over their face, comes first: its shape
/// functions yield those of the other without loss of digits (shaders/common/tet_pair.glsl), however flat the other is.
TetPairing paired_tets(const Model& model);

}  // namespace fascia
