#include "sim/gpu/contact/body_translations.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "sim/contact/tissue_surface.h"

namespace fascia {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd flat(const std::vector<Vector3d>& vectors) {
  return Eigen::Map<const VectorXd>(vectors.data()->data(), 3 * static_cast<Index>(vectors.size()));
}

/// max(0, force), its integral and its slope, rounded over a width of `round` > 0. Points begin to press and let go in
/// turn while bodies slide over them; Newton's method makes steps of any length only where that is smooth.
struct Pressing {
  double force, integral, slope;
};

Pressing pressing_of(double force, double round) {
  if (force <= -round) return {0, 0, 0};
  if (force >= round) return {force, 0.5 * force * force + round * round / 6, 1};
  const double over = force + round;
  return {over * over / (4 * round), over * over * over / (12 * round), over / (2 * round)};
}

class Problem {
 public:
  Problem(const std::vector<BodyInertia>& bodies, const std::vector<BodyContact>& contacts, double length)
      : first_(bodies.size(), -1) {
    Index count = 0;
    double reach = 0;  // [m] that a body may go, amply
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      if (!(bodies[body].mass > 0)) continue;
      first_[body] = 3 * count++;
      reach = std::max(reach, 8 * bodies[body].missing.norm() / bodies[body].mass);
    }
    inertia_.setZero(3 * count);
    pull_.setZero(3 * count);
    for (std::size_t body = 0; body < bodies.size(); ++body) {
      if (first_[body] < 0) continue;
      inertia_.segment<3>(first_[body]).setConstant(bodies[body].mass / (length * length));
      pull_.segment<3>(first_[body]) = bodies[body].missing / (length * length);
    }
    std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(contacts_), [&](const BodyContact& c) {
      return first_[c.bodies[0]] >= 0 || (c.bodies[1] != BodyContact::kTool && first_[c.bodies[1]] >= 0);
    });
    for (const BodyContact& c : contacts_) reach = std::max(reach, 2 * (c.depth + c.before / c.stiffness));
    std::erase_if(contacts_, [&](const BodyContact& c) {
      return c.bound <= 0 && c.before + c.stiffness * (c.depth + reach) <= 0;
    });
  }

  Index unknowns() const { return pull_.size(); }
  /// Of contact where bodies are, and of inertia [N].
  double largest_force() const {
    double largest = unknowns() > 0 ? pull_.cwiseAbs().maxCoeff() : 0;
    for (const BodyContact& c : contacts_) largest = std::max(largest, c.before + c.stiffness * c.depth);
    return largest;
  }

  double evaluate(const VectorXd& d, double round, VectorXd& gradient, MatrixXd* hessian) const {
    double energy = 0.5 * d.dot(inertia_.cwiseProduct(d)) - d.dot(pull_);
    gradient = inertia_.cwiseProduct(d) - pull_;
    if (hessian) *hessian = inertia_.asDiagonal();
    for (const BodyContact& c : contacts_) {
      const Index at[] = {first_[c.bodies[0]], c.bodies[1] == BodyContact::kTool ? -1 : first_[c.bodies[1]]};
      Vector3d way(0, 0, 0);
      if (at[0] >= 0) way += d.segment<3>(at[0]);
      if (at[1] >= 0) way -= d.segment<3>(at[1]);
      const Pressing pressing = pressing_of(c.before + c.stiffness * (c.depth - c.normal.dot(way)), round);
      energy += pressing.integral / c.stiffness;
      Vector3d force = pressing.force * c.normal;
      Eigen::Matrix3d block = pressing.slope * c.stiffness * c.normal * c.normal.transpose();
      if (c.bound > 0) {
        const Vector3d q = c.tangential - c.sliding * (way - way.dot(c.slip_normal) * c.slip_normal);
        energy += sticking_energy(q, c.bound, c.sliding);
        force += within(q, c.bound);
        block += sticking_hessian(q, c.bound, c.sliding, c.slip_normal);
      }
      if (at[0] >= 0) gradient.segment<3>(at[0]) -= force;
      if (at[1] >= 0) gradient.segment<3>(at[1]) += force;
      for (int row = 0; hessian && row < 2; ++row)
        for (int column = 0; column < 2; ++column)
          if (at[row] >= 0 && at[column] >= 0)
            hessian->block<3, 3>(at[row], at[column]) += row == column ? block : Eigen::Matrix3d(-block);
    }
    return energy;
  }

  std::vector<Vector3d> of_bodies(const VectorXd& d) const {
    std::vector<Vector3d> result(first_.size(), Vector3d::Zero());
    for (std::size_t body = 0; body < first_.size(); ++body)
      if (first_[body] >= 0) result[body] = d.segment<3>(first_[body]);
    return result;
  }

 private:
  std::vector<BodyContact> contacts_;  // of bodies that move, which press or may
  std::vector<Index> first_;           // [body] of its unknowns, or -1
  VectorXd inertia_, pull_;
};

}  // namespace

std::vector<Vector3d> best_translations(const std::vector<BodyInertia>& bodies,
                                        const std::vector<BodyContact>& contacts, double length, double least) {
  constexpr int kFewSteps = 4, kMostSteps = 12, kMostHalves = 20;
  constexpr double kArmijo = 1e-4;                              // of the decrease that a step promises
  constexpr double kRounds[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5};  // of the largest force
  const Problem problem(bodies, contacts, length);
  VectorXd d = VectorXd::Zero(problem.unknowns()), gradient, there;
  const double largest = problem.largest_force();
  if (problem.unknowns() == 0 || !(largest > 0)) return problem.of_bodies(d);
  MatrixXd hessian;
  // Whether d is the minimum, after so many steps at most.
  const auto descend = [&](double round, int steps) {
    for (int step = 0; step < steps; ++step) {
      const double energy = problem.evaluate(d, round, gradient, &hessian);
      const VectorXd way = hessian.ldlt().solve(-gradient);
      const double promised = -way.dot(gradient);
      if (!(way.cwiseAbs().maxCoeff() > least)) return true;
      double share = 1;
      int half = 0;
      for (; half < kMostHalves; ++half, share *= 0.5)
        if (problem.evaluate(d + share * way, round, there, nullptr) <= energy - kArmijo * share * promised) break;
      if (half == kMostHalves) return false;
      d += share * way;
    }
    return false;
  };
  // Most bodies are nearly where they should be.
  if (descend(kRounds[std::size(kRounds) - 1] * largest, kFewSteps)) return problem.of_bodies(d);
  for (const double round : kRounds) descend(round * largest, kMostSteps);
  return problem.of_bodies(d);
}

BodyTranslations::BodyTranslations(const Model& model, const SimBuffers& buffers)
    : bodies_(bodies_of_vertices(model)),
      at_place_(buffers.vertex_count),
      held_(std::max<std::size_t>(model.bodies.size(), 1)),
      least_(1e-9 * buffers.size) {
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < held.size(); ++v) {
    at_place_[buffers.placement.place[v]] = bodies_[v];
    held_[bodies_[v]] |= held[v];
  }
  materials_changed(model);
}

void BodyTranslations::materials_changed(const Model& model) { masses_ = lumped_masses(model); }

void BodyTranslations::begin(const std::vector<VertexStiffness>& springs) {
  free_.clear();
  for (const char held : held_) free_.push_back(!held);
  for (const VertexStiffness& spring : springs) free_[at_place_[spring.vertex]] = 0;
}

bool BodyTranslations::may_move() const {
  return std::any_of(held_.begin(), held_.end(), [](char held) { return !held; });
}

bool BodyTranslations::empty() const {
  return std::none_of(free_.begin(), free_.end(), [](char free) { return free; });
}

bool BodyTranslations::move(const ContactEnergy& contact, const std::vector<Vector3d>& predicted, double length,
                            std::vector<Vector3d>& u) const {
  std::vector<BodyInertia> bodies(free_.size());
  for (std::size_t v = 0; v < masses_.size(); ++v) {
    if (!free_[bodies_[v]]) continue;
    bodies[bodies_[v]].mass += masses_[v];
    bodies[bodies_[v]].missing += masses_[v] * (predicted[v] - u[v]);
  }
  const std::vector<Vector3d> ways = best_translations(bodies, contact.of_bodies(bodies_, flat(u)), length, least_);
  if (std::all_of(ways.begin(), ways.end(), [](const Vector3d& way) { return way.isZero(0); })) return false;
  for (std::size_t v = 0; v < masses_.size(); ++v)
    if (masses_[v] > 0) u[v] += ways[bodies_[v]];
  return true;
}

}  // namespace fascia
