// The energy of tissue that touches tissue in a step: that of sim/contact/contact_energy.h with the depth -gap of a
// pair instead of that in a tool, and with the way of the two sides against each other since the start of the step.
// Forces on the two sides are equal and opposite.
#pragma once
#include <vector>

#include "sim/contact/contact_block.h"
#include "sim/contact/pair_row.h"
#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia {

/// The force of one body on another, at the end of a stage or as the mean over a step (sim/contact/step_loads.h).
struct PairLoad {
  std::array<std::uint32_t, 2> bodies{};  // in Model::bodies, ascending; the same twice: a body on itself
  Eigen::Vector3d force{0, 0, 0};         // [N] on the second, -force on the first; of a body on itself the sum is 0
  double normal = 0;                      // [N] sum of the normal forces of all pairs, whatever their directions
  std::uint32_t pairs = 0;                // that press
  double deepest = 0;                     // [m] of them within the skin, at least 0
};

class PairEnergy {
 public:
  /// `memory`: of all contact; that of pairs from `first_row` on. Shorter: no forces.
  PairEnergy(const Model& model, std::vector<PairRow> rows, const ContactMemory& memory, std::uint32_t first_row);

  /// As ContactEnergy::evaluate().
  double evaluate(const Eigen::VectorXd& u, Eigen::VectorXd& gradient, double* magnitude = nullptr) const;
  double rounding(const Eigen::VectorXd& u) const;                   // as that of ContactEnergy
  std::vector<ContactBlock> blocks(const Eigen::VectorXd& u) const;  // of the Hessian, which is semidefinite
  bool empty() const { return rows_.empty(); }
  void remember(const Eigen::VectorXd& u, double share, ContactMemory& memory) const;
  void put_rows(std::vector<RowState>& states, const Eigen::VectorXd& u) const;  // as ContactEnergy
  void append_to(std::vector<BodyContact>& contacts, const std::vector<std::uint32_t>& bodies,
                 const Eigen::VectorXd& u) const;  // as ContactEnergy::of_bodies()
  std::vector<PairLoad> loads(const Eigen::VectorXd& u) const;

 private:
  struct Contact {
    double pressing, depth;
    Eigen::Vector3d tangential;  // q
  };
  Contact contact_of(std::size_t row, const Eigen::VectorXd& u) const;
  double reach_of(const PairRow& row, const Eigen::VectorXd& u) const;      // [m] largest coordinate
  Eigen::Vector3d force_of(std::size_t row, const Contact& contact) const;  // on the side of the normal

  const Model& model_;
  double friction_;
  std::uint32_t first_row_;
  std::vector<PairRow> rows_;
  std::vector<ContactForce> before_;  // [rows] lambda and t, across the normal
};

/// That of two bodies, ascending; added without forces if they are not among `loads`, which ascend.
PairLoad& load_of(std::vector<PairLoad>& loads, const std::array<std::uint32_t, 2>& bodies);
/// Adds the force of a pair on the side of its normal, of which `pressing` [N] is normal, to the load of its bodies.
void add_load(std::vector<PairLoad>& loads, const PairRow& row, const Eigen::Vector3d& force, double pressing,
              double depth);
/// The load of two bodies, ascending; without forces if they are not among `loads`.
PairLoad load_between(const std::vector<PairLoad>& loads, const std::array<std::uint32_t, 2>& bodies);
/// Ascending pairs of bodies that may touch each other; a body that may touch itself is a pair with itself.
std::vector<std::array<std::uint32_t, 2>> touching_bodies(const Model& model);

}  // namespace fascia
