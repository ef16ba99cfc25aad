#include "sim/reference/minimizer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fascia::reference {
namespace {

using Eigen::VectorXd;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// While a step shrinks the gradient to this share, the current factorization is as good as a new one at a tenth of its
// cost: an iteration with it gains at least as many digits per second. In motion, that of the step before often is.
constexpr double reuse_below = 0.1;

constexpr double roundings = 32;  // of an objective, in those of its terms
// Near the minimum objectives differ by rounding alone, which in stiff bodies that turn is more than that of the terms;
// slopes still tell (Hager, Zhang 2005, approximate Wolfe conditions). Of the terms:
constexpr double level = 1e-10;
// Newton's steps shrink quadratically. As many in a row as small as this, in coordinates, that leave the gradient as
// large as it was are rounding, also where its bound is too narrow: far displacements of stiff bodies, large tools.
constexpr double still_step = 1e-12;
constexpr int still_steps = 4;

}  // namespace

Minimizer::Minimizer(const ElasticSystem& system)
    : system_(system), hessian_(system.empty_hessian()), cholesky_(hessian_, system.elimination_tree()) {}

Minimizer::Value Minimizer::evaluate(const Potential& potential, const VectorXd& u) const {
  Value value;
  VectorXd internal;
  double rounded = 0;
  value.energy = system_.evaluate(u, potential.viscous, internal, &rounded);
  // A body that has moved as a whole has displacements with larger roundings than its energy.
  value.magnitude = std::abs(value.energy) + internal.cwiseAbs().dot(u.cwiseAbs()) + rounded;
  VectorXd applied = VectorXd::Zero(u.size()), motion = VectorXd::Zero(u.size()), gradient = internal;
  for (std::size_t v = 0; v < system_.first_dof().size(); ++v) {
    if (system_.first_dof()[v] < 0) continue;
    for (std::size_t i = 3 * v; i < 3 * v + 3; ++i) {
      const double distance = u[i] - potential.target[i];
      const double kinetic = 0.5 * potential.inertia[i] * distance * distance, work = potential.force[i] * u[i];
      value.energy += kinetic - work;
      value.magnitude += kinetic + std::abs(work);
      gradient[i] += potential.inertia[i] * distance - potential.force[i];
      applied[i] = potential.force[i];
      motion[i] = potential.inertia[i] * (u[i] - potential.start[i]);
    }
  }
  if (potential.coupled.acts()) {
    const VectorXd distance = u - potential.coupled.predicted, inertial = potential.coupled.force(distance);
    const double kinetic = 0.5 * inertial.dot(distance);
    value.energy += kinetic;
    value.magnitude += kinetic;
    gradient += inertial;
    motion += potential.coupled.force(u - potential.start);
  }
  double contact = 0;  // [N]
  if (potential.contact) {
    VectorXd forces = VectorXd::Zero(u.size());
    const double energy = potential.contact->evaluate(u, forces, &value.magnitude);
    value.energy += energy;
    value.magnitude += std::abs(energy);
    gradient += forces;
    contact = forces.norm();
  }
  value.gradient = system_.free_part(gradient);
  value.force_scale = std::max({internal.norm(), applied.norm(), motion.norm(), contact});
  return value;
}

bool Minimizer::climbs(const Potential& potential, const VectorXd& from, const VectorXd& to) const {
  const Value before = evaluate(potential, from), after = evaluate(potential, to);
  return after.energy > before.energy + roundings * epsilon * (before.magnitude + after.magnitude);
}

void Minimizer::factorize(const Potential& potential, const VectorXd& u) {
  VectorXd scale;
  const VectorXd inertia = system_.free_part(potential.inertia);
  factored_ = {};
  for (const bool project : {false, true}) {
    system_.assemble(u, potential.viscous, project, hessian_, scale);
    hessian_.diagonal() += inertia;
    if (potential.coupled.acts()) potential.coupled.mass->add_coupled(potential.coupled.factor, system_, hessian_);
    if (potential.contact) add_contact(*potential.contact, u, project, scale);
    coupled_.reset();
    if (potential.contact && !potential.contact->pairs().empty()) couple(potential.contact->pairs(), u, scale);
    if (!project) {
      scale += potential.inertia.cwiseProduct(u.cwiseAbs() + potential.target.cwiseAbs()) + potential.force.cwiseAbs();
      if (potential.coupled.acts())
        scale += potential.coupled.force(u.cwiseAbs() + potential.coupled.predicted.cwiseAbs());
      rounding_ = epsilon * system_.free_part(scale).norm();
    }
    if (!factorize_sum()) continue;
    if (!project && !potential.contact) factored_ = {potential.inertia, potential.coupled.factor, potential.viscous.h};
    return;
  }
  // Still singular: a body without constraints. A growing multiple of the identity gives a usable step.
  const double largest = hessian_.diagonal().maxCoeff();
  double shift = 1e-10 * std::max(largest, std::numeric_limits<double>::min());
  while (!factorize_sum(shift)) shift *= 100;
}

void Minimizer::add_contact(const ContactEnergy& contact, const VectorXd& u, bool project, VectorXd& scale) {
  for (const ContactBlock& block : contact.blocks(u, project)) {
    system_.add_block(block.row_vertex, block.column_vertex, block.hessian, hessian_);
    scale.segment<3>(3 * static_cast<Eigen::Index>(block.row_vertex)).array() +=
        block.reach * block.hessian.cwiseAbs().rowwise().sum().array();
  }
}

void Minimizer::couple(const PairEnergy& pairs, const VectorXd& u, VectorXd& scale) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const ContactBlock& block : pairs.blocks(u)) {
    scale.segment<3>(3 * static_cast<Eigen::Index>(block.row_vertex)).array() +=
        block.reach * block.hessian.cwiseAbs().rowwise().sum().array();
    const int row = system_.first_dof()[block.row_vertex], column = system_.first_dof()[block.column_vertex];
    if (row < 0 || column < 0 || row > column) continue;
    for (int r = 0; r < 3; ++r)
      for (int c = row == column ? r : 0; c < 3; ++c) entries.emplace_back(row + r, column + c, block.hessian(r, c));
  }
  SparseMatrix sum(hessian_.rows(), hessian_.cols());
  sum.setFromTriplets(entries.begin(), entries.end());
  coupled_hessian_ = hessian_ + sum;
  coupled_ = std::make_unique<CoupledCholesky>();
  coupled_->analyzePattern(coupled_hessian_);
}

bool Minimizer::has_factor_of(const Potential& potential) const {
  return !potential.contact && factored_.length == potential.viscous.h &&
         factored_.coupled == potential.coupled.factor && factored_.inertia.size() == potential.inertia.size() &&
         factored_.inertia == potential.inertia;
}

bool Minimizer::factorize_sum(double shift) {
  if (!coupled_) return cholesky_.factorize(hessian_, shift);
  coupled_->setShift(shift);
  coupled_->factorize(coupled_hessian_);
  return coupled_->info() == Eigen::Success;
}

VectorXd Minimizer::solve(const VectorXd& right) const {
  return coupled_ ? VectorXd(coupled_->solve(right)) : cholesky_.solve(right);
}

bool Minimizer::line_search(const Potential& potential, const VectorXd& direction, VectorXd& u, Value& value,
                            double& step) const {
  const double slope = value.gradient.dot(direction);
  const double rounding = roundings * epsilon * value.magnitude;
  for (step = 1; step > 1e-12; step /= 2) {
    VectorXd trial = u;
    system_.add_to_free(direction, step, trial);
    Value trial_value = evaluate(potential, trial);
    const double rise = trial_value.energy - value.energy;
    const bool lower = rise <= 1e-4 * step * slope + rounding;  // Armijo; false for NaN
    const bool flatter = std::abs(rise) <= level * value.magnitude &&
                         std::abs(trial_value.gradient.dot(direction)) <= 0.5 * std::abs(slope);
    if (lower || flatter) {
      u = std::move(trial);
      value = std::move(trial_value);
      return true;
    }
  }
  return false;
}

void Minimizer::move_held(const Potential& potential, const VectorXd& change, VectorXd& u) {
  if (system_.dof_count() == 0) {
    u += change;
    return;
  }
  factorize(potential, u);
  VectorXd dragged = system_.hessian_times(u, potential.viscous, change);
  if (potential.coupled.acts()) dragged += potential.coupled.force(change);
  const VectorXd direction = -solve(evaluate(potential, u).gradient + system_.free_part(dragged));
  u += change;
  VectorXd taken_along = u;
  system_.add_to_free(direction, 1, taken_along);
  const bool inside_out = system_.min_det_f(taken_along) <= 0 && system_.min_det_f(u) > 0;
  if (!inside_out && evaluate(potential, taken_along).energy < evaluate(potential, u).energy) u = taken_along;
}

NewtonReport Minimizer::minimize(const Potential& potential, double tolerance, const Limits& limits, VectorXd& u) {
  const NewtonReport report = descend(potential, tolerance, limits, u);
  if (!report.converged) factored_ = {};
  return report;
}

NewtonReport Minimizer::descend(const Potential& potential, double tolerance, const Limits& limits, VectorXd& u) {
  NewtonReport report;
  Value value = evaluate(potential, u);
  bool reuse = has_factor_of(potential);
  double previous = std::numeric_limits<double>::infinity();
  int still = 0;
  const double coordinate = system_.largest_coordinate();
  if (!reuse) rounding_ = 0;
  for (;; ++report.iterations) {
    const double residual = value.gradient.norm();
    report.relative_residual = residual == 0 ? 0 : residual / value.force_scale;
    const bool stays = residual > 0.5 * previous, at_rounding = residual <= rounding_ && stays;
    const bool inside_out = limits.upright && system_.min_det_f(u) <= 0;
    report.converged = !inside_out && (report.relative_residual <= tolerance || at_rounding);
    if (report.converged || inside_out || report.iterations == limits.iterations || limits.stop.stop_requested())
      return report;

    if (!reuse) factorize(potential, u);
    const VectorXd direction = -solve(value.gradient);
    const double smallest = still_step * std::max(coordinate, u.lpNorm<Eigen::Infinity>());
    still = stays && direction.lpNorm<Eigen::Infinity>() <= smallest ? still + 1 : 0;
    if (still == still_steps) {
      report.converged = true;
      return report;
    }
    double step = 0;
    const VectorXd before = reuse ? u : VectorXd();
    const bool found = line_search(potential, direction, u, value, step);
    if (reuse && (!found || value.gradient.norm() > residual)) {
      // Near the solution energies differ by rounding alone, and an old factorization may lead away from it.
      u = before;
      value = evaluate(potential, u);
      reuse = false;
      continue;
    }
    if (!found) {
      report.converged = residual <= rounding_;
      return report;
    }
    reuse = step == 1 && value.gradient.norm() < reuse_below * residual;
    previous = residual;
  }
}

}  // namespace fascia::reference
