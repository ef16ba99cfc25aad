// Whether tissue goes from one state to another without going through tools or other bodies. A static solve asks it of
// every fall and of every part of the way of its tools: its states have no motion between them that would be known to
// be possible, so that the straight one of all vertices stands for it.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "sim/contact/contact_surface.h"
#include "sim/contact/tissue/box_tree.h"
#include "sim/contact/tissue/penetration.h"
#include "sim/contact/tissue/tissue_surface.h"
#include "sim/tool/tool_motion.h"

namespace fascia {

/// Whether a point that goes straight `from` a place `to` another one, in the axes of the shape, enters it by one side
/// and is at another one in the end, outside or inside. Of what begins deeper inside than a quarter of the finest part,
/// the side is not known: no. `half_thickness`: of the skin [m].
bool goes_through(const ToolShape& shape, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                  double half_thickness);

class ClearWay {
 public:
  /// `skin`: between surfaces of tissue [m]. Both references must outlive this object.
  ClearWay(const Model& model, const ContactSurface& contact, double skin);
  /// `from`, `to`: displacements [3 * vertex_count] [m] at the two ends of `motion`. What began inside, or behind a
  /// face, may leave.
  bool operator()(const Eigen::VectorXd& from, const Eigen::VectorXd& to, const ToolMotion& motion);
  /// The same of the tools that move in `motion` alone. Each goes straight as the tissue sees it.
  bool of_moving_tools(const Eigen::VectorXd& from, const Eigen::VectorXd& to, const ToolMotion& motion) const;
  /// Whether the surfaces of two bodies cut each other at `to` and do not at `from`.
  bool cuts(const Eigen::VectorXd& from, const Eigen::VectorXd& to);

 private:
  struct Body {
    BoxTree tree;  // around the ways of its triangles
    std::vector<std::uint32_t> triangles, vertices, edges;
  };
  bool clear_of(const ContactPiece& piece, const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                const ToolMotion& motion) const;
  bool clear_of_tissue(const Eigen::VectorXd& from, const Eigen::VectorXd& to);
  Eigen::AlignedBox3d way_of(std::uint32_t v) const { return Eigen::AlignedBox3d(from_[v]).extend(to_[v]); }
  void place(const Eigen::VectorXd& from, const Eigen::VectorXd& to);
  bool enters(std::uint32_t vertex, const Triangle& triangle) const;
  bool enters(const TissueEdge& first, const TissueEdge& second) const;
  /// Whether the two sides were in touch before.
  bool touched(const Passage& passage, const std::array<std::uint32_t, 4>& vertices) const;
  std::array<Eigen::Vector3d, 4> at(const std::vector<Eigen::Vector3d>& x,
                                    const std::array<std::uint32_t, 4>& v) const {
    return {x[v[0]], x[v[1]], x[v[2]], x[v[3]]};
  }
  Eigen::Vector3d normal_at(double share, std::uint32_t triangle) const;  // outward, twice its area long

  const Model& model_;
  const ContactSurface& contact_;
  double skin_;
  std::vector<Triangle> triangles_;
  std::vector<TissueEdge> edges_;
  std::vector<std::array<std::uint32_t, 3>> sides_;  // [triangle] its edges
  std::vector<std::uint32_t> body_of_;               // [vertex_count]
  std::vector<Body> bodies_;                         // none where bodies do not touch each other
  std::vector<Eigen::Vector3d> from_, to_;           // [vertex_count] x
};

}  // namespace fascia
