// An order of the tets along a space-filling curve: neighbours in space come close in memory, whatever order the mesh
// file had.
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

/// The tets that a solver needs, along the curve: all but those whose vertices are all fixed, which never strain.
std::vector<std::uint32_t> solved_tets(const Model& model);
/// The same in pairs. Of a pair the larger tet, which is the higher one over their face, comes first: from its shape
/// functions those of the other one are made without losing digits (shaders/common/tet_pair.glsl), however flat that
/// one is.
TetPairing paired_tets(const Model& model);

}  // namespace fascia
