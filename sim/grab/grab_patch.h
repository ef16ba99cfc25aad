// The patch of tissue that a grab pulls: its vertices, and each vertex's share of the grip. The mouse and the grabs of
// a scene use the same rule.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "sim/model/model.h"
#include "sim/surface/embedding.h"

namespace fascia {

inline constexpr double kPatchRadius = 0.08;  // default radius of a grab, in scene radii
inline constexpr double kGrip = 3;  // stiffness of a grab over E * patch radius: a thick body indented by a disc has 2

struct PatchVertex {
  std::uint32_t vertex;
  double share;    // of the grab's grip [-]; the sum is 1
  double modulus;  // mean Young's modulus of the tets around [Pa]
};

/// The tet that contains the point, or else the nearest. `positions` of the vertices that the tets name, at rest or
/// deformed.
EmbeddedPoint tet_at(std::span<const Tet> tets, std::span<const Eigen::Vector3d> positions,
                     const Eigen::Vector3d& point);
/// Index into Model::bodies.
std::size_t body_of(const Model& model, std::uint32_t vertex);
/// Half the diagonal of the box around all tets at rest [m].
double scene_radius(const Model& model);

/// The free vertices of the body of `place` within `radius` [m] of `point` in `positions` (currently deformed or at
/// rest; mesh vertices first), with shares that are full in the middle and fade towards the rim, and in addition those
/// of `place`, by their weights. So a radius smaller than a tet, or a point on a surface embedded in large tets, grabs
/// exactly that point. Empty if all of these vertices are constrained.
std::vector<PatchVertex> grab_patch(const Model& model, std::span<const Eigen::Vector3d> positions,
                                    const Eigen::Vector3d& point, double radius, const EmbeddedPoint& place);
/// The free ones of these vertices. Those that span faces of the surface pull on these alone, with the shares of an
/// even traction; where no face is spanned, each has the same share.
std::vector<PatchVertex> even_patch(const Model& model, const std::vector<std::uint32_t>& vertices);

/// The default stiffness [N/m] of a patch of this size: the tissue's own, times `grip`.
double patch_stiffness(const std::vector<PatchVertex>& patch, double radius, double grip = kGrip);

}  // namespace fascia
