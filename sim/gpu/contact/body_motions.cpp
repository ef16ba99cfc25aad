#include "sim/gpu/contact/body_motions.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/elements/quadratic_tet.h"
#include "sim/model/unconstrained_parts.h"

namespace fascia {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
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

Matrix3d cross(const Vector3d& v) {
  return (Matrix3d() << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0).finished();
}

// Minus the second derivatives of f . (w x (w x r)) / 2 by a turn w, summed over forces: of `moments`, sum of f r^T.
Matrix3d of_turned_arms(const Matrix3d& moments) {
  return moments.trace() * Matrix3d::Identity() - 0.5 * (moments + moments.transpose());
}

// Of inertia, turned arms take this much at most: no turn is best where they take more, as of what falls over its edge.
constexpr double kMostTaken = 0.9;

Matrix3d turning_of(const BodyInertia& body, double length) {
  const Matrix3d turned = of_turned_arms(body.missing_arms + length * length * body.moments);
  for (double share = 1; share > 0.1; share *= 0.5)
    if ((kMostTaken * body.turning + share * turned).llt().info() == Eigen::Success)
      return body.turning + share * turned;
  return body.turning;
}

// The unknowns of a body: its way, and its turn times its radius of gyration.
class Problem {
 public:
  Problem(const std::vector<BodyInertia>& bodies, const std::vector<BodyContact>& contacts, double length)
      : bodies_(bodies), first_(bodies.size(), -1), radius_(bodies.size()) {
    Index count = 0;
    double reach = 0;  // [m] that a body may go, amply
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const BodyInertia& body = bodies[b];
      if (!(body.mass > 0)) continue;
      first_[b] = kUnknowns * count++;
      radius_[b] = std::sqrt(0.5 * body.turning.trace() / body.mass);
      reach = std::max(reach, 8 * body.missing.norm() / body.mass);
    }
    inertia_.setZero(kUnknowns * count, kUnknowns * count);
    pull_.setZero(kUnknowns * count);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (first_[b] < 0) continue;
      const double per_square = 1 / (length * length), turned = per_square / radius_[b];
      inertia_.block<3, 3>(first_[b], first_[b]).diagonal().setConstant(bodies[b].mass * per_square);
      inertia_.block<3, 3>(first_[b] + 3, first_[b] + 3) = turned / radius_[b] * turning_of(bodies[b], length);
      pull_.segment<3>(first_[b]) = per_square * bodies[b].missing;
      pull_.segment<3>(first_[b] + 3) = turned * bodies[b].missing_turn;
    }
    contacts_.reserve(contacts.size());
    std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(contacts_), [&](const BodyContact& c) {
      return first_[c.bodies[0]] >= 0 || (c.bodies[1] != BodyContact::kTool && first_[c.bodies[1]] >= 0);
    });
    for (const BodyContact& c : contacts_) reach = std::max(reach, 2 * (c.depth + c.before / c.stiffness));
    std::erase_if(contacts_, [&](const BodyContact& c) {
      return c.bound <= 0 && c.before + c.stiffness * (c.depth + reach) <= 0;
    });
    sides_.reserve(contacts_.size());
    for (const BodyContact& c : contacts_) sides_.push_back({side(c, 0), side(c, 1)});
  }

  Index unknowns() const { return pull_.size(); }
  /// Of contact where bodies are, and of inertia [N].
  double largest_force() const {
    double largest = unknowns() > 0 ? pull_.cwiseAbs().maxCoeff() : 0;
    for (const BodyContact& c : contacts_) largest = std::max(largest, c.before + c.stiffness * c.depth);
    return largest;
  }

  double evaluate(const VectorXd& d, double round, VectorXd& gradient, MatrixXd* hessian) const {
    const VectorXd borne = inertia_ * d;
    double energy = 0.5 * d.dot(borne) - d.dot(pull_);
    gradient = borne - pull_;
    if (hessian) *hessian = inertia_;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const BodyContact& c = contacts_[k];
      const Sides& sides = sides_[k];
      const Vector3d way = way_of(sides, d);
      const Pressing pressing = pressing_of(c.before + c.stiffness * (c.depth - c.normal.dot(way)), round);
      energy += pressing.integral / c.stiffness;
      Vector3d force = pressing.force * c.normal;
      Matrix3d block = pressing.slope * c.stiffness * c.normal * c.normal.transpose();
      if (c.bound > 0) {
        const Vector3d q = c.tangential - c.sliding * (way - way.dot(c.slip_normal) * c.slip_normal);
        energy += sticking_energy(q, c.bound, c.sliding);
        force += within(q, c.bound);
        block += sticking_hessian(q, c.bound, c.sliding, c.slip_normal);
      }
      for (const Side& s : sides) {
        if (s.first < 0) continue;
        gradient.segment<3>(s.first) -= s.sign * force;
        gradient.segment<3>(s.first + 3) -= s.sign * s.arm.cross(force);
      }
      if (hessian && (pressing.slope > 0 || c.bound > 0)) add(block, sides, *hessian);
    }
    return energy;
  }

  std::vector<BodyMotion> of_bodies(const VectorXd& d) const {
    std::vector<BodyMotion> result(first_.size());
    for (std::size_t b = 0; b < first_.size(); ++b)
      if (first_[b] >= 0) result[b] = {d.segment<3>(first_[b]), d.segment<3>(first_[b] + 3) / radius_[b]};
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const BodyContact& c = contacts_[k];
      const Vector3d force = force_of(c, way_of(sides_[k], d));
      for (std::size_t side = 0; side < 2; ++side)
        if (const Side& s = sides_[k][side]; s.first >= 0)
          result[c.bodies[side]].moments += s.sign * radius_[c.bodies[side]] * force * s.arm.transpose();
    }
    return result;
  }

 private:
  static constexpr Index kUnknowns = 6;
  struct Side {
    Index first;  // unknown of its body, or -1
    double sign;
    Vector3d arm;  // from the center, over the radius
  };
  using Sides = std::array<Side, 2>;
  Side side(const BodyContact& c, std::size_t k) const {
    const std::uint32_t body = c.bodies[k];
    if (body == BodyContact::kTool || first_[body] < 0) return {-1, 0, {0, 0, 0}};
    return {first_[body], k == 0 ? 1.0 : -1.0, (c.places[k] - bodies_[body].center) / radius_[body]};
  }
  // Of the sides against each other.
  static Vector3d way_of(const Sides& sides, const VectorXd& d) {
    Vector3d way(0, 0, 0);
    for (const Side& s : sides)
      if (s.first >= 0) way += s.sign * (d.segment<3>(s.first) + d.segment<3>(s.first + 3).cross(s.arm));
    return way;
  }
  static Vector3d force_of(const BodyContact& c, const Vector3d& way) {
    const Vector3d force = std::max(0.0, c.before + c.stiffness * (c.depth - c.normal.dot(way))) * c.normal;
    if (c.bound <= 0) return force;
    return force + within(c.tangential - c.sliding * (way - way.dot(c.slip_normal) * c.slip_normal), c.bound);
  }
  // `block`: the second derivatives by the way of the sides against each other.
  static void add(const Matrix3d& block, const Sides& sides, MatrixXd& hessian) {
    for (const Side& row : sides)
      for (const Side& column : sides) {
        if (row.first < 0 || column.first < 0) continue;
        const Matrix3d signed_block = row.sign * column.sign * block;
        const Matrix3d turned = cross(row.arm) * signed_block, by_turn = -cross(column.arm);
        hessian.block<3, 3>(row.first, column.first) += signed_block;
        hessian.block<3, 3>(row.first, column.first + 3) += signed_block * by_turn;
        hessian.block<3, 3>(row.first + 3, column.first) += turned;
        hessian.block<3, 3>(row.first + 3, column.first + 3) += turned * by_turn;
      }
  }

  const std::vector<BodyInertia>& bodies_;
  std::vector<BodyContact> contacts_;  // of bodies that move, which press or may
  std::vector<Sides> sides_;           // of contacts_
  std::vector<Index> first_;           // [body] of its unknowns, or -1
  std::vector<double> radius_;         // [body] of gyration [m]
  MatrixXd inertia_;
  VectorXd pull_;
};

}  // namespace

std::vector<BodyMotion> best_motions(const std::vector<BodyInertia>& bodies, const std::vector<BodyContact>& contacts,
                                     double length, double least) {
  constexpr int kMostSteps = 12, kMostHalves = 40;
  constexpr double kArmijo = 1e-4;                              // of the decrease that a step promises
  constexpr double kRounds[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5};  // of the largest force
  constexpr double kLast = 1e-9;
  constexpr double kRounding = 1e-14;  // of sums of the energies of some thousand points
  const Problem problem(bodies, contacts, length);
  VectorXd d = VectorXd::Zero(problem.unknowns()), gradient;
  const double largest = problem.largest_force();
  if (problem.unknowns() == 0 || !(largest > 0)) return problem.of_bodies(d);
  MatrixXd hessian;
  // Whether d is the minimum, after so many steps at most.
  const auto descend = [&](double round, int steps) {
    double energy = problem.evaluate(d, round, gradient, &hessian);
    for (int step = 0; step < steps; ++step) {
      const VectorXd from = d, way = hessian.ldlt().solve(-gradient);
      const double promised = -way.dot(gradient), before = energy;
      if (!(way.cwiseAbs().maxCoeff() > least)) return true;
      if (promised <= kRounding * std::abs(before)) {  // energies say no more
        d += way;
        return true;
      }
      double share = 1;
      for (int half = 0;; ++half, share *= 0.5) {
        d = from;
        if (half == kMostHalves) return false;
        d += share * way;
        energy = problem.evaluate(d, round, gradient, &hessian);
        if (energy <= before - kArmijo * share * promised) break;
      }
    }
    return false;
  };
  // Most bodies are nearly where they should be, and then rounds are a detour: over that of the largest force a body on
  // many points is carried above all of them.
  const double sharp = kRounds[std::size(kRounds) - 1] * largest;
  if (!descend(sharp, kMostSteps)) {
    const VectorXd at_once = d;
    for (const double round : kRounds) descend(round * largest, kMostSteps);
    if (problem.evaluate(d, sharp, gradient, nullptr) >= problem.evaluate(at_once, sharp, gradient, nullptr))
      d = at_once;
  }
  // Each of the many points that touch and bear nothing has a force of the size of a round.
  descend(kLast * largest, kMostSteps);
  return problem.of_bodies(d);
}

BodyMotions::BodyMotions(const Model& model, const SimBuffers& buffers)
    : model_(&model), at_place_(buffers.vertex_count), size_(buffers.size) {
  const UnconstrainedParts parts = unconstrained_parts(model, model.held());
  bodies_ = parts.part;
  free_.resize(parts.parts + 1);
  for (std::size_t v = 0; v < bodies_.size(); ++v) at_place_[buffers.placement.place[v]] = bodies_[v];
  materials_changed();
}

void BodyMotions::materials_changed() {
  masses_ = moving_masses(*model_);
  weighs_.clear();
  for (const double mass : lumped_masses(*model_)) weighs_.push_back(mass > 0);
  std::vector<Eigen::AlignedBox3d> boxes(free_.size());
  std::vector<double> slowest(free_.size(), std::numeric_limits<double>::infinity());
  for (std::size_t t = 0; t < model_->tets.size(); ++t) {
    const std::uint32_t body = bodies_[model_->tets[t][0]];
    const Material& material = model_->materials[model_->tet_material[t]];
    slowest[body] = std::min(slowest[body], std::sqrt(material.young_modulus / material.density));
    for (const std::uint32_t v : model_->tets[t]) boxes[body].extend(model_->rest_positions[v]);
  }
  crossing_.assign(free_.size(), 0);
  for (std::size_t b = 0; b < crossing_.size(); ++b)
    if (!boxes[b].isEmpty()) crossing_[b] = 0.5 * boxes[b].diagonal().norm() / slowest[b];
}

void BodyMotions::begin(const std::vector<VertexStiffness>& springs) {
  std::fill(free_.begin(), free_.end(), 1);
  free_.front() = 0;
  for (const VertexStiffness& spring : springs) free_[at_place_[spring.vertex]] = 0;
}

bool BodyMotions::empty() const {
  return std::none_of(free_.begin(), free_.end(), [](char free) { return free; });
}

bool BodyMotions::are_stiff(double length) const {
  for (std::size_t b = 0; b < free_.size(); ++b)
    if (free_[b] && crossing_[b] > length) return false;
  return true;
}

std::vector<BodyInertia> BodyMotions::inertia_of(const std::vector<Vector3d>& predicted,
                                                 const std::vector<Vector3d>& u) const {
  std::vector<BodyInertia> bodies(free_.size());
  // Calls f with the body, mass, place and missing way of all that moves.
  const auto for_masses = [&](const auto& f) {
    for (std::size_t v = 0; v < masses_.own.size(); ++v)
      if (free_[bodies_[v]])
        f(bodies[bodies_[v]], masses_.own[v], model_->rest_positions[v] + u[v], predicted[v] - u[v]);
    for (std::size_t t = 0; t < masses_.centroid.size(); ++t) {
      const std::uint32_t body = bodies_[model_->tets[t][0]];
      if (masses_.centroid[t] == 0 || !free_[body]) continue;
      Vector3d place(0, 0, 0), way(0, 0, 0);
      const ElementVertices element = model_->element(t);
      for (std::size_t n = 0; n < element.size(); ++n) {
        const std::uint32_t v = element[n];
        place += QuadraticTet::at_centroid(n) * (model_->rest_positions[v] + u[v]);
        way += QuadraticTet::at_centroid(n) * (predicted[v] - u[v]);
      }
      f(bodies[body], masses_.centroid[t], place, way);
    }
  };
  for_masses([](BodyInertia& body, double mass, const Vector3d& x, const Vector3d& way) {
    body.mass += mass;
    body.center += mass * x;
    body.missing += mass * way;
  });
  for (BodyInertia& body : bodies)
    if (body.mass > 0) body.center /= body.mass;
  for_masses([](BodyInertia& body, double mass, const Vector3d& x, const Vector3d& way) {
    const Vector3d arm = x - body.center;
    body.turning += mass * (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());
    body.missing_turn += mass * arm.cross(way);
    body.missing_arms += mass * way * arm.transpose();
  });
  return bodies;
}

bool BodyMotions::move(const ContactEnergy* contact, const std::vector<Vector3d>& predicted, double length,
                       std::vector<Vector3d>& u) const {
  constexpr int kMostPasses = 8;        // turns are not small
  constexpr double kLargestTurn = 0.5;  // [rad] in a pass
  const double least = 1e-12 * size_;   // [m] of displacements, which are finer than places
  bool moves = false;
  std::vector<BodyMotion> motions(free_.size());
  for (int pass = 0; pass < kMostPasses; ++pass) {
    std::vector<BodyInertia> inertia = inertia_of(predicted, u);
    for (std::size_t b = 0; b < motions.size(); ++b) inertia[b].moments = motions[b].moments;
    const auto contacts = contact ? contact->of_bodies(bodies_, flat(u)) : std::vector<BodyContact>();
    motions = best_motions(inertia, contacts, length, least);
    for (BodyMotion& motion : motions)
      if (const double angle = motion.turn.norm(); angle > kLargestTurn) motion.turn *= kLargestTurn / angle;
    bool turns = false;
    for (std::size_t v = 0; v < bodies_.size(); ++v) {
      const BodyMotion& motion = motions[bodies_[v]];
      const double angle = motion.turn.norm();
      if (!weighs_[v] || (motion.way.isZero(0) && angle == 0)) continue;
      const Vector3d arm = model_->rest_positions[v] + u[v] - inertia[bodies_[v]].center;
      u[v] += motion.way;
      if (angle > 0) u[v] += Eigen::AngleAxisd(angle, motion.turn / angle) * arm - arm;
      moves = true;
      turns |= angle * angle * arm.norm() > least;
    }
    if (!turns) break;
  }
  return moves;
}

}  // namespace fascia
