// Quadratic tets as linear ones over the same vertices, for what does not depend on the curves between them: coarse
// functions, boundaries, pictures.
#pragma once
#include "sim/model/model.h"

namespace fascia {

/// The part of the model that solvers need, each quadratic tet cut into eight linear ones, four at its corners and four
/// around the shortest diagonal of the octahedron between them (Bey 1995). Linear tets are kept.
Model linear_parts(const Model& model);

/// Tets over the same vertices for pictures: those of the model, quadratic ones cut in eight.
struct LinearTets {
  std::vector<Tet> tets;
  std::vector<std::uint32_t> source;  // index into Model::tets
};
/// Of the model's tets from `begin` on.
LinearTets linear_tets(const Model& model, std::size_t begin, std::size_t count);

/// The cut of one tet whose vertices are at these places [m]. Positive volumes for a positive one.
std::array<Tet, 8> cut_in_eight(const Tet& corners, const MidEdges& middles,
                                const std::vector<Eigen::Vector3d>& places);

}  // namespace fascia
