// The patch of tissue that a grab holds: which vertices, and what share of its grip each of them has. One rule for the
// mouse and for the grabs of a scene.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "sim/model/model.h"
#include "sim/surface/embedding.h"

namespace fascia {

inline constexpr double kPatchRadius = 0.08;  // of a grab that says nothing else, in scene radii
inline constexpr double kGrip = 3;  // stiffness of a grab over E * patch radius: a thick body indented by a disc has 2

struct PatchVertex {
  std::uint32_t vertex;
  double share;    // of the grab's grip [-]; all together 1
  double modulus;  // mean Young's modulus of the tets around [Pa]
};

/// The tet that holds the point, or the one that misses it least. `positions` of the vertices that the tets name, at
/// rest or deformed.
EmbeddedPoint tet_at(std::span<const Tet> tets, std::span<const Eigen::Vector3d> positions,
                     const Eigen::Vector3d& point);
/// Index into Model::bodies.
std::size_t body_of(const Model& model, std::uint32_t vertex);
/// Half the diagonal of the box around all tets at rest [m].
double scene_radius(const Model& model);

/// The free vertices of the body of `place` within `radius` [m] of `point` in `positions` (as deformed now or at rest;
/// mesh vertices first), firm in the middle and fading to the rim, and beside them those of `place`, by their weights:
/// so a radius smaller than a tet, or a point on a surface embedded in large ones, holds that very point. Empty where
/// all of these are held.
std::vector<PatchVertex> grab_patch(const Model& model, std::span<const Eigen::Vector3d> positions,
                                    const Eigen::Vector3d& point, double radius, const EmbeddedPoint& place);
/// The free ones of these vertices, each with the same share.
std::vector<PatchVertex> even_patch(const Model& model, const std::vector<std::uint32_t>& vertices);

/// Stiffness [N/m] that a patch of this size has unless a number is given: the tissue's own, times `grip`.
double patch_stiffness(const std::vector<PatchVertex>& patch, double radius, double grip = kGrip);

}  // namespace fascia
