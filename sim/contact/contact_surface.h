// The contact points of a model: fixed material points of its surface at which tools press on it.
//
// Faces of the boundary are split into 4^L equal triangles, whose corners are the points of level L: level 0 has the
// vertices, and every level contains the ones below. A tool uses the level at which points are at most half of its
// finest radius apart, since a thin tool would pass between vertices. Around its edges it has more of them: an edge
// that lies between points is in the tissue, which then cannot slide out from under it.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/model/model.h"
#include "sim/model/state.h"
#include "sim/tool/rigid_pose.h"

namespace fascia {

struct ContactPoint {
  /// x = sum_a weights[a] (X + u)[vertices[a]]. Unused corners have weight 0 and repeat the first vertex, which is a
  /// free one.
  std::array<std::uint32_t, 3> vertices;
  std::array<double, 3> weights;
  double area;  // [m^2] that a vertex there would stand for: as much at every level

  /// Of values [vertex], that at the point.
  Eigen::Vector3d at(const std::vector<Eigen::Vector3d>& values) const {
    return sum_of([&](std::uint32_t v) -> const Eigen::Vector3d& { return values[v]; });
  }
  /// [m] where the point is, of rest positions and displacements [vertex].
  Eigen::Vector3d place(const std::vector<Eigen::Vector3d>& rest, const std::vector<Eigen::Vector3d>& u) const {
    return sum_of([&](std::uint32_t v) -> Eigen::Vector3d { return rest[v] + u[v]; });
  }
  /// Of u [3 * vertex].
  Eigen::Vector3d place(const std::vector<Eigen::Vector3d>& rest, const Eigen::VectorXd& u) const {
    return sum_of(
        [&](std::uint32_t v) -> Eigen::Vector3d { return rest[v] + u.segment<3>(3 * static_cast<Eigen::Index>(v)); });
  }

 private:
  template <class OfVertex>
  Eigen::Vector3d sum_of(const OfVertex& value) const {
    Eigen::Vector3d sum(0, 0, 0);
    for (std::size_t k = 0; k < 3; ++k) sum += weights[k] * value(vertices[k]);
    return sum;
  }
};

/// A rigid piece of a tool, and the rows that it has: one for each point of its level.
struct ContactPiece {
  std::uint32_t tool, piece;  // in Model::tools, and in that tool
  int level;
  std::uint32_t points;      // the first ones of ContactSurface::points
  std::uint32_t everywhere;  // the first ones of these; the others have a row near edges of the piece only
  std::uint32_t first_row;   // in ContactMemory of a state
};

struct ContactSurface {
  static constexpr int kFinestLevel = 3, kFinestLevelOfEdges = 2;
  static constexpr std::size_t kMostPieces = 32;  // bits of the mask of a point on the GPU

  std::vector<ContactPoint> points;  // level by level; none where all corners are held
  std::vector<ContactPiece> pieces;
  std::uint32_t row_count = 0;
  std::vector<double> finest_parts;  // [tool] [m] finest_radius(), or, about sharp edges, about what points resolve
  double edge_width = 0;             // [m] how far from edges of pieces all of their points have rows
  double first_reach = 0;            // [m] how near to pieces points count as bearing at a first touch
  double full_slip = 0;              // [m] after which any point bears all of its friction (contact_block.h)
  std::vector<std::string> notes;    // tools that are too thin or too sharp for the surface, one line each

  bool empty() const { return row_count == 0; }
};

/// The penalty on depth, over the stiffness M A / l of the tissue below, M being its surface_modulus(). In single steps
/// 1 and 100 do as well; in motion a softer one lets tools sink in deeper, and a harder one makes every first touch an
/// impact.
inline constexpr double kContactPenalty = 10;

/// Whether a point of a piece has a row in a stage: those everywhere do, and what is near an edge, or bore a force
/// `before` [N]. `x`: at the start of the stage.
bool has_row(const ContactSurface& surface, const ContactPiece& piece, std::uint32_t point, const ToolShape& shape,
             const Eigen::Vector3d& x, const RigidPose& from, const RigidPose& to, double before);

/// Without points if the model has no tools.
ContactSurface make_contact_surface(const Model& model);

/// As ToolDepth (sim/tool/tool_approach.h), of the tissue displaced by `u`: 1 with the middle of a piece in the tissue,
/// or a point as deep in it as a quarter of its finest part. A plane has one side and is never deep.
double depth_in_tissue(const Model& model, const ContactSurface& surface, const std::vector<Eigen::Vector3d>& u,
                       std::size_t tool, const ToolPlace& place);

/// What is likely a mistake in a scene's contact, one line each: tools that are too thin for the surface or begin
/// wholly inside tissue, bodies that begin in each other or in tools, and a skin that is thicker than what it covers.
/// Throws Error, which names `where`, for a skin thicker than a whole body, and for more than kMostPieces pieces.
std::vector<std::string> check_contact(const Model& model, const std::string& where);

/// Penalty stiffness [N/m] of every point, [points]: s M A / l with the tissue's surface_modulus() M and l = 2 V / A of
/// the vertices (l: the height of a cell), s = 10 times the factor of the scene. A is that of a vertex at every level,
/// since a tool that is smaller than a cell, or has a sharp edge, presses with few points, each as stiff as the tissue
/// below it.
std::vector<double> contact_stiffness(const Model& model, const ContactSurface& surface);

/// [points] stage_stiffness() in a stage of this length [s], of contact_stiffness() and the masses of vertices.
std::vector<double> stage_stiffness(const Model& model, const ContactSurface& surface,
                                    const std::vector<double>& stiffness, double length);

/// The forces that rows of tools remember, after the stiffness of points [N/m] changed: they fall with it. Tissue that
/// is pressed in as before and has become softer would else be thrown out by what the stiffer one bore.
void soften(ContactMemory& memory, const ContactSurface& surface, const std::vector<double>& before,
            const std::vector<double>& after);

}  // namespace fascia
