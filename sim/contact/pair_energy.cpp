#include "sim/contact/pair_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fascia {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

PairEnergy::PairEnergy(const Model& model, std::vector<PairRow> rows, const ContactMemory& memory,
                       std::uint32_t first_row)
    : model_(model), friction_(model.contact.friction), first_row_(first_row), rows_(std::move(rows)) {
  before_.resize(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const std::size_t row = first_row_ + force_row(rows_[i].slot);
    if (row >= memory.size()) continue;
    before_[i] = memory[row];
    before_[i].friction -= before_[i].friction.dot(rows_[i].normal) * rows_[i].normal;
  }
}

PairEnergy::Contact PairEnergy::contact_of(std::size_t i, const VectorXd& u) const {
  const PairRow& row = rows_[i];
  Vector3d way = -row.start;
  for (std::size_t k = 0; k < 4; ++k)
    way += row.weights[k] * u.segment<3>(3 * static_cast<Eigen::Index>(row.vertices[k]));
  Contact contact;
  contact.depth = -row.gap - way.dot(row.normal);
  contact.pressing = std::max(0.0, before_[i].normal + row.stiffness * contact.depth);
  contact.tangential =
      before_[i].friction - kStickingPenalty * row.stiffness * (way - way.dot(row.normal) * row.normal);
  return contact;
}

Vector3d PairEnergy::force_of(std::size_t i, const Contact& contact) const {
  return contact.pressing * rows_[i].normal + within(contact.tangential, friction_ * before_[i].normal);
}

double PairEnergy::evaluate(const VectorXd& u, VectorXd& gradient, double* magnitude) const {
  double energy = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Contact contact = contact_of(i, u);
    const double before = before_[i].normal, bound = friction_ * before_[i].normal;
    if (contact.pressing == 0 && before_[i].normal == 0) continue;
    energy += 0.5 * (contact.pressing - before) * (contact.pressing + before) / rows_[i].stiffness;
    if (bound > 0) energy += sticking_energy(contact.tangential, bound, kStickingPenalty * rows_[i].stiffness);
    const Vector3d force = force_of(i, contact);
    for (std::size_t k = 0; k < 4; ++k) {
      const Eigen::Index at = 3 * static_cast<Eigen::Index>(rows_[i].vertices[k]);
      gradient.segment<3>(at) -= rows_[i].weights[k] * force;
      if (magnitude) *magnitude += std::abs(rows_[i].weights[k]) * force.norm() * u.segment<3>(at).norm();
    }
  }
  return energy;
}

double PairEnergy::reach_of(const PairRow& row, const VectorXd& u) const {
  double reach = 0;
  for (const std::uint32_t v : row.vertices)
    reach = std::max(reach,
                     (model_.rest_positions[v] + u.segment<3>(3 * static_cast<Eigen::Index>(v))).cwiseAbs().maxCoeff());
  return reach;
}

double PairEnergy::rounding(const VectorXd& u) const {
  double largest = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (contact_of(i, u).pressing > 0)
      largest = std::max(largest, std::numeric_limits<double>::epsilon() * rows_[i].stiffness * reach_of(rows_[i], u));
  return largest;
}

std::vector<ContactBlock> PairEnergy::blocks(const VectorXd& u) const {
  std::vector<ContactBlock> blocks;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const PairRow& row = rows_[i];
    const Contact contact = contact_of(i, u);
    const double bound = friction_ * before_[i].normal;
    const bool touches = before_[i].normal + row.stiffness * contact.depth >= 0;
    if (!touches && bound == 0) continue;
    Matrix3d hessian = Matrix3d::Zero();
    if (touches) hessian += row.stiffness * row.normal * row.normal.transpose();
    if (bound > 0) hessian += sticking_hessian(contact.tangential, bound, kStickingPenalty * row.stiffness, row.normal);
    const double reach = reach_of(row, u);
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < 4; ++b)
        if (const double weight = row.weights[a] * row.weights[b]; weight != 0)
          blocks.push_back({row.vertices[a], row.vertices[b], weight * hessian, reach});
  }
  return blocks;
}

void PairEnergy::remember(const VectorXd& u, double share, ContactMemory& memory) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Contact contact = contact_of(i, u);
    ContactForce& force = memory[first_row_ + force_row(rows_[i].slot)];
    force.normal = kept_force(contact.pressing, before_[i].normal, share, rows_[i].stiffness);
    force.friction = before_[i].normal > 0 ? within(contact.tangential, friction_ * force.normal) : Vector3d(0, 0, 0);
    met_in(memory[first_row_ + met_row(rows_[i].slot)], rows_[i].slot) = rows_[i].met;
  }
}

void PairEnergy::put_rows(std::vector<RowState>& states, const VectorXd& u) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Contact contact = contact_of(i, u);
    states[first_row_ + force_row(rows_[i].slot)] = {contact.depth, contact.tangential};
  }
}

void PairEnergy::append_to(std::vector<BodyContact>& contacts, const std::vector<std::uint32_t>& bodies,
                           const VectorXd& u) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const PairRow& row = rows_[i];
    std::array<std::uint32_t, 2> sides{};
    std::array<Vector3d, 2> places{Vector3d(0, 0, 0), Vector3d(0, 0, 0)};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t v = row.vertices[k];
      const std::size_t side = row.sides[k];
      sides[side] = bodies[v];
      places[side] += (side == 0 ? row.weights[k] : -row.weights[k]) *
                      (model_.rest_positions[v] + u.segment<3>(3 * static_cast<Eigen::Index>(v)));
    }
    if (sides[0] == sides[1]) continue;
    const Contact contact = contact_of(i, u);
    contacts.push_back({sides, places, row.normal, row.stiffness, before_[i].normal, contact.depth, row.normal,
                        contact.tangential, kStickingPenalty * row.stiffness, friction_ * before_[i].normal});
  }
}

std::vector<PairLoad> PairEnergy::loads(const VectorXd& u) const {
  std::vector<PairLoad> loads;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Contact contact = contact_of(i, u);
    if (contact.pressing > 0 || before_[i].normal > 0)
      add_load(loads, rows_[i], force_of(i, contact), contact.pressing, contact.depth);
  }
  return loads;
}

PairLoad& load_of(std::vector<PairLoad>& loads, const std::array<std::uint32_t, 2>& bodies) {
  const auto place = std::lower_bound(loads.begin(), loads.end(), bodies,
                                      [](const PairLoad& load, const auto& wanted) { return load.bodies < wanted; });
  return place != loads.end() && place->bodies == bodies ? *place : *loads.insert(place, PairLoad{bodies});
}

void add_load(std::vector<PairLoad>& loads, const PairRow& row, const Vector3d& force, double pressing, double depth) {
  const bool ascends = row.bodies[0] <= row.bodies[1];
  const std::array<std::uint32_t, 2> bodies{row.bodies[ascends ? 0 : 1], row.bodies[ascends ? 1 : 0]};
  PairLoad& load = load_of(loads, bodies);
  if (bodies[0] != bodies[1]) load.force += ascends ? -force : force;
  if (pressing <= 0) return;
  load.normal += pressing;
  ++load.pairs;
  load.deepest = std::max(load.deepest, depth);
}

PairLoad load_between(const std::vector<PairLoad>& loads, const std::array<std::uint32_t, 2>& bodies) {
  const auto found =
      std::find_if(loads.begin(), loads.end(), [&](const PairLoad& load) { return load.bodies == bodies; });
  return found != loads.end() ? *found : PairLoad{bodies};
}

std::vector<std::array<std::uint32_t, 2>> touching_bodies(const Model& model) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  const auto count = static_cast<std::uint32_t>(model.bodies.size());
  for (std::uint32_t a = 0; a < count; ++a)
    for (std::uint32_t b = a; b < count; ++b)
      if (a == b ? model.contact.self : model.contact.bodies) pairs.push_back({a, b});
  return pairs;
}

}  // namespace fascia
