// The energy of contact in a step, in double precision: a penalty with multipliers that stay from step to step
// (Hestenes 1969, Powell 1969), and Coulomb friction by return mapping (Simo, Laursen 1992).
//
// For every row, a contact point x at a piece of a tool, with d the signed distance of the piece minus half of the
// skin's thickness, n its normal, k the penalty, and lambda and t the forces that the step before left:
//
//   normal    (max(0, lambda - k d)^2 - lambda^2) / (2 k)
//   friction  with s the way of x against the piece across its normal n0 at the start, c the penalty on sliding
//   (sliding_penalty()),
//             q = t - c s, b = mu lambda:  |q| <= b: |q|^2 / (2 c), else (b |q| - b^2 / 2) / c
//   force on the tissue  max(0, lambda - k d) n + q min(1, b / |q|)
//
// lambda, t, b, c and n0 are constants of the step, so this is one smooth energy. Tissue that touches tissue adds that
// of sim/contact/pair_energy.h.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "sim/contact/contact_block.h"
#include "sim/contact/contact_surface.h"
#include "sim/contact/pair_energy.h"
#include "sim/contact/tool_load.h"
#include "sim/model/state.h"
#include "sim/tool/tool_entry.h"
#include "sim/tool/tool_motion.h"

namespace fascia {

class ContactEnergy {
 public:
  /// `start`: displacements [3 * vertex_count] at the start of the step. `stiffness`: row_stiffness(). A memory
  /// shorter than the rows and slots means no forces. `pairs`: of the tissue with itself. `aim`: displacements where
  /// velocities lead, if any. The first two outlive this object.
  ContactEnergy(const Model& model, const ContactSurface& surface, const std::vector<double>& stiffness,
                const ContactMemory& memory, const Eigen::VectorXd& start, const ToolMotion& motion,
                std::vector<PairRow> pairs = {}, const std::vector<Eigen::Vector3d>& aim = {});

  /// Planes that stand for pieces in the step (sim/tool/tool_entry.h), in the axes of the scene, by row of the memory.
  void take_planes(const std::function<std::optional<ToolEntry>(std::uint32_t row)>& plane_at);
  /// All rows at `u`, to [row of the memory].
  void put_rows(std::vector<RowState>& states, const Eigen::VectorXd& u) const;

  /// Energy [J] at displacements `u`; adds its derivatives to `gradient` [3 * vertex_count], and to `magnitude` what
  /// times the machine epsilon bounds its rounding [J]: forces times the coordinates that they are computed from.
  double evaluate(const Eigen::VectorXd& u, Eigen::VectorXd& gradient, double* magnitude = nullptr) const;
  /// Bound on the rounding of the force of any row that presses at `u` [N].
  double rounding(const Eigen::VectorXd& u) const;
  /// The Hessian as a sum of blocks. `semidefinite`: without the curvature of the tools' surfaces. Those of tools are
  /// between vertices of one face, those of pairs() between any.
  std::vector<ContactBlock> blocks(const Eigen::VectorXd& u, bool semidefinite) const;
  const PairEnergy& pairs() const { return pairs_; }

  /// As long as the memory at the start, or as the rows of tools if that had none.
  ContactMemory memory_after(const Eigen::VectorXd& u, double share = 1) const;
  std::vector<ToolLoad> loads(const Eigen::VectorXd& u) const;  // [tool]
  /// Of the vertices' `bodies` at `u`, with tools and with each other.
  std::vector<BodyContact> of_bodies(const std::vector<std::uint32_t>& bodies, const Eigen::VectorXd& u) const;

 private:
  struct Piece {
    const ToolShape* shape;
    RigidPose pose;          // at the end
    Eigen::Vector3d origin;  // of the tool, at the end
    double friction;
  };
  struct Row {
    std::uint32_t piece, point;  // of the surface
    double stiffness;
    Eigen::Vector3d friction;     // t, across `normal`
    Eigen::Vector3d anchor;       // where the piece takes the point to that was at the start [m]
    Eigen::Vector3d normal;       // n0
    double before;                // lambda, and the N by which friction goes [N]
    double sliding;               // c [N/m]
    std::optional<double> plane;  // offset of the plane across `normal` that stands for the piece (tool_entry.h) [m]
  };
  struct Contact {
    Eigen::Vector3d x, normal, tangential;  // tangential: q
    Eigen::Matrix3d curvature;              // of the distance
    double pressing, depth;                 // N, and -d
  };
  Contact contact_of(const Row& row, const Eigen::VectorXd& u) const;
  /// [m] largest coordinate that the force is computed from
  static double reach_of(const Contact& contact, const Piece& placed);
  std::uint32_t memory_row(const Row& row) const { return surface_.pieces[row.piece].first_row + row.point; }
  const Piece& piece_of(const Row& row) const { return pieces_[row.piece]; }
  const ContactPoint& point_of(const Row& row) const { return surface_.points[row.point]; }

  const Model& model_;
  const ContactSurface& surface_;
  std::vector<Piece> pieces_;
  std::vector<Row> rows_;  // those that there are
  PairEnergy pairs_;
  std::size_t slots_;  // of the memory
};

}  // namespace fascia
