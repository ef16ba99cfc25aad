// Moves bodies as wholes to where the objective of a stage is least along their translations. Elastic forces do not
// change with these, so that inertia and contact alone say where it is: a convex problem of three unknowns for each
// body, solved in double precision. Iterations find these directions late where contact is stiff: a step that presses
// too much is shortened as a whole, and bodies that slide or part lose their momentum with it.
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
  double mass = 0;                   // [kg]; 0: it stays
  Eigen::Vector3d missing{0, 0, 0};  // sum of m (u~ - u) over its vertices [kg m]
};

/// [body] the translations [m] in a stage of this length [s], to `least` [m]. Tools count as the planes that they are
/// where points are.
std::vector<Eigen::Vector3d> best_translations(const std::vector<BodyInertia>& bodies,
                                               const std::vector<BodyContact>& contacts, double length, double least);

class BodyTranslations {
 public:
  BodyTranslations() = default;
  BodyTranslations(const Model& model, const SimBuffers& buffers);
  void materials_changed(const Model& model);

  /// In a stage with springs at places of the buffers' vertices: bodies that are held, or that a spring pulls, stay.
  void begin(const std::vector<VertexStiffness>& springs);
  bool may_move() const;
  bool empty() const;  // whether no body moves, after begin()
  /// Moves the bodies from displacements `u` [vertex of the model]; false: all are where they should be. `predicted`:
  /// u~ [m]; `length`: of the stage [s].
  bool move(const ContactEnergy& contact, const std::vector<Eigen::Vector3d>& predicted, double length,
            std::vector<Eigen::Vector3d>& u) const;

 private:
  std::vector<std::uint32_t> bodies_;    // [vertex of the model]
  std::vector<std::uint32_t> at_place_;  // [place of a vertex] its body
  std::vector<double> masses_;           // [vertex of the model] [kg]
  std::vector<char> held_, free_;        // [body]
  double least_ = 0;                     // [m] that matters in single precision
};

}  // namespace fascia
