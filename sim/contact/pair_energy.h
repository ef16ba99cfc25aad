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

/// The force of one body on another at the end of a step.
struct PairLoad {
  std::array<std::uint32_t, 2> bodies{};  // in Model::bodies, ascending; the same twice: a body on itself
  Eigen::Vector3d force{0, 0, 0};         // [N] on the second; of a body on itself the sum is 0
  std::uint32_t pairs = 0;                // that press
  double deepest = 0;                     // [m] of them within the skin, at least 0
};

class PairEnergy {
 public:
  /// `memory`: of all contact; those of pairs from `first_slot` on. Shorter: no forces.
  PairEnergy(const Model& model, std::vector<PairRow> rows, const ContactMemory& memory, std::uint32_t first_slot);

  double evaluate(const Eigen::VectorXd& u, Eigen::VectorXd& gradient) const;
  std::vector<ContactBlock> blocks(const Eigen::VectorXd& u) const;  // of the Hessian, which is semidefinite
  bool empty() const { return rows_.empty(); }
  void remember(const Eigen::VectorXd& u, ContactMemory& memory) const;
  std::vector<PairLoad> loads(const Eigen::VectorXd& u) const;

 private:
  struct Contact {
    double pressing, depth;
    Eigen::Vector3d tangential;  // q
  };
  Contact contact_of(std::size_t row, const Eigen::VectorXd& u) const;
  Eigen::Vector3d force_of(std::size_t row, const Contact& contact) const;  // on the side of the normal

  const Model& model_;
  double friction_;
  std::uint32_t first_slot_;
  std::vector<PairRow> rows_;
  std::vector<ContactForce> before_;  // [rows] lambda and t, across the normal
};

/// Adds the force of a pair on the side of its normal to the load of its bodies.
void add_load(std::vector<PairLoad>& loads, const PairRow& row, const Eigen::Vector3d& force, bool presses,
              double depth);

}  // namespace fascia
