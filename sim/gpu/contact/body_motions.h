// Moves bodies as wholes to where the objective of a stage is least along their rigid motions. Elastic energy does not
// change with these, so that inertia and contact alone say where it is: a convex problem of six unknowns for each body
// where turns are small, solved in double precision. Iterations find these directions late where contact is stiff: a
// step that presses too much is shortened as a whole, and bodies that slide, tip or part lose their momentum with it.
//
// A turn w moves a place r by w x r + w x (w x r) / 2. Through the second part forces at the ends of arms change the
// curvature along turns: for a ball of a centimeter that rolls on its facets, by more than half of its inertia over a
// step of 1/60 s.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/coarse/coarse_matrix.h"
#include "sim/contact/contact_energy.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

/// What inertia asks of a body.
struct BodyInertia {
  double mass = 0;                                         // [kg]; 0: it stays
  Eigen::Vector3d missing{0, 0, 0};                        // sum of m (u~ - u) over its masses [kg m]
  Eigen::Vector3d center{0, 0, 0};                         // of mass [m]
  Eigen::Matrix3d turning = Eigen::Matrix3d::Zero();       // sum of m (r.r 1 - r r^T), r from the center [kg m^2]
  Eigen::Vector3d missing_turn{0, 0, 0};                   // sum of r x m (u~ - u) [kg m^2]
  Eigen::Matrix3d missing_arms = Eigen::Matrix3d::Zero();  // sum of m (u~ - u) r^T [kg m^2]
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();       // of contact, as far as they are known: sum of f r^T [N m]
};

/// x goes to x + way + turn x (x - center), or to where a turn by that vector takes it.
struct BodyMotion {
  Eigen::Vector3d way{0, 0, 0}, turn{0, 0, 0};        // [m], [rad]
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();  // of contact there: sum of f r^T [N m]
};

/// [body] the motions in a stage of this length [s], to `least` [m]. Tools count as the planes that they are where
/// points are, and turns as small.
std::vector<BodyMotion> best_motions(const std::vector<BodyInertia>& bodies, const std::vector<BodyContact>& contacts,
                                     double length, double least);

/// Bodies are unconstrained parts of the model.
class BodyMotions {
 public:
  /// `model`: in its own order, outlives this.
  BodyMotions(const Model& model, const SimBuffers& buffers);
  void materials_changed();

  bool may_move() const { return free_.size() > 1; }  // whether nothing holds some body
  /// In a stage with springs at places of the buffers' vertices: bodies that are held, or that a spring pulls, stay.
  void begin(const std::vector<VertexStiffness>& springs);
  bool empty() const;  // whether no body moves, after begin()
  /// Whether a hit is felt in all of every body that moves within a stage of this length [s]: whether sound goes from
  /// its middle to its ends, where the tissue is softest.
  bool are_stiff(double length) const;
  /// Moves the bodies from displacements `u` [vertex of the model]; false: all are where they should be. `contact`:
  /// null where nothing touches; `predicted`: u~ [m]; `length`: of the stage [s].
  bool move(const ContactEnergy* contact, const std::vector<Eigen::Vector3d>& predicted, double length,
            std::vector<Eigen::Vector3d>& u) const;

 private:
  std::vector<BodyInertia> inertia_of(const std::vector<Eigen::Vector3d>& predicted,
                                      const std::vector<Eigen::Vector3d>& u) const;

  const Model* model_;
  std::vector<std::uint32_t> bodies_;    // [vertex of the model] UnconstrainedParts::part
  std::vector<std::uint32_t> at_place_;  // [place of a vertex] its body
  MovingMasses masses_;
  std::vector<char> weighs_;      // [vertex of the model] whether it is of a tet
  std::vector<char> free_;        // [body] which move; the first one is all that is held
  std::vector<double> crossing_;  // [body] that sound takes from the middle to the ends, at most [s]
  double size_ = 0;               // of the tissue [m]
};

}  // namespace fascia
