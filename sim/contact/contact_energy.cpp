#include "sim/contact/contact_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/tool/shape_distance.h"

namespace fascia {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

ContactEnergy::ContactEnergy(const Model& model, const ContactSurface& surface, const std::vector<double>& stiffness,
                             const ContactMemory& memory, const VectorXd& start, const ToolMotion& motion,
                             std::vector<PairRow> pairs, const std::vector<Vector3d>& aim)
    : model_(model),
      surface_(surface),
      pairs_(model, std::move(pairs), memory, surface.row_count),
      slots_(std::max<std::size_t>(memory.size(), surface.row_count)) {
  const bool remembers = memory.size() >= surface.row_count;
  rows_.reserve(stiffness.size() - static_cast<std::size_t>(std::count(stiffness.begin(), stiffness.end(), 0)));
  for (std::uint32_t i = 0; i < surface.pieces.size(); ++i) {
    const ContactPiece& piece = surface.pieces[i];
    const Tool& tool = model.tools[piece.tool];
    const RigidPose before = tool.pose_of_piece(piece.piece, motion.from[piece.tool]);
    pieces_.push_back({&tool.shape, tool.pose_of_piece(piece.piece, motion.to[piece.tool]),
                       motion.to[piece.tool].pose.origin, tool.friction});
    const RigidPose& after = pieces_.back().pose;
    for (std::uint32_t p = 0; p < piece.points; ++p) {
      if (stiffness[piece.first_row + p] == 0) continue;
      Row& row = rows_.emplace_back();
      row.piece = i;
      row.point = p;
      const Vector3d local = before.to_local(surface.points[p].place(model.rest_positions, start));
      row.stiffness = stiffness[piece.first_row + p];
      row.anchor = after.to_scene(local);
      row.normal = after.axes * distance_to(tool.shape, local).normal.normalized();
      row.before = remembers ? memory[piece.first_row + p].normal : 0;
      row.sliding = sliding_penalty(row.stiffness, tool.friction * row.before, surface.full_slip);
      row.friction.setZero();
      if (!aim.empty())
        if (const auto entry = entry_into(
                tool.shape, local, after.to_local(surface.points[p].place(model.rest_positions, aim)),
                after.to_local(surface.points[p].place(model.rest_positions, start)), 0.5 * model.contact.thickness)) {
          row.normal = after.axes * entry->normal;
          row.plane = entry->offset + row.normal.dot(after.origin);
        }
      if (!remembers) continue;
      row.friction = after.axes * memory[piece.first_row + p].friction;
      row.friction -= row.friction.dot(row.normal) * row.normal;
    }
  }
}

void ContactEnergy::take_planes(const std::function<std::optional<ToolEntry>(std::uint32_t row)>& plane_at) {
  for (Row& row : rows_)
    if (const std::optional<ToolEntry> plane = plane_at(memory_row(row))) {
      row.normal = plane->normal;
      row.plane = plane->offset;
    }
}

void ContactEnergy::put_rows(std::vector<RowState>& states, const VectorXd& u) const {
  for (const Row& row : rows_) {
    const Contact contact = contact_of(row, u);
    states[memory_row(row)] = {contact.depth, contact.tangential};
  }
  pairs_.put_rows(states, u);
}

ContactEnergy::Contact ContactEnergy::contact_of(const Row& row, const VectorXd& u) const {
  const Piece& placed = piece_of(row);
  Contact contact;
  contact.x = point_of(row).place(model_.rest_positions, u);
  ShapeDistance distance{row.plane ? row.normal.dot(contact.x) - *row.plane : 0, row.normal, Matrix3d::Zero()};
  if (!row.plane) {
    distance = distance_to(*placed.shape, placed.pose.to_local(contact.x));
    distance.normal = placed.pose.axes * distance.normal;
    distance.curvature = placed.pose.axes * distance.curvature * placed.pose.axes.transpose();
  }
  contact.normal = distance.normal;
  contact.curvature = distance.curvature;
  contact.depth = 0.5 * model_.contact.thickness - distance.distance;
  contact.pressing = std::max(0.0, row.before + row.stiffness * contact.depth);
  const Vector3d way = contact.x - row.anchor;
  contact.tangential = row.friction - row.sliding * (way - way.dot(row.normal) * row.normal);
  return contact;
}

double ContactEnergy::reach_of(const Contact& contact, const Piece& placed) {
  return std::max(contact.x.cwiseAbs().maxCoeff(), placed.pose.origin.cwiseAbs().maxCoeff());
}

double ContactEnergy::evaluate(const VectorXd& u, VectorXd& gradient, double* magnitude) const {
  double energy = pairs_.evaluate(u, gradient, magnitude);
  for (const Row& row : rows_) {
    const Piece& placed = piece_of(row);
    const Contact contact = contact_of(row, u);
    const double bound = placed.friction * row.before;
    if (contact.pressing == 0 && row.before == 0) continue;
    energy += 0.5 * (contact.pressing - row.before) * (contact.pressing + row.before) / row.stiffness;
    Vector3d force = contact.pressing * contact.normal;
    if (bound > 0) {
      energy += sticking_energy(contact.tangential, bound, row.sliding);
      force += within(contact.tangential, bound);
    }
    if (magnitude) *magnitude += force.norm() * reach_of(contact, placed);
    const ContactPoint& point = point_of(row);
    for (std::size_t k = 0; k < 3; ++k)
      gradient.segment<3>(3 * static_cast<Eigen::Index>(point.vertices[k])) -= point.weights[k] * force;
  }
  return energy;
}

double ContactEnergy::rounding(const VectorXd& u) const {
  double largest = pairs_.rounding(u);
  for (const Row& row : rows_) {
    const Piece& placed = piece_of(row);
    const Contact contact = contact_of(row, u);
    if (contact.pressing > 0)
      largest = std::max(largest, std::numeric_limits<double>::epsilon() * row.stiffness * reach_of(contact, placed));
  }
  return largest;
}

std::vector<ContactBlock> ContactEnergy::blocks(const VectorXd& u, bool semidefinite) const {
  std::vector<ContactBlock> blocks;
  for (const Row& row : rows_) {
    const Piece& placed = piece_of(row);
    const Contact contact = contact_of(row, u);
    const double bound = placed.friction * row.before;
    // A point that just touches counts: a body that is set down would else have no stiffness against its weight.
    const bool touches = row.before + row.stiffness * contact.depth >= 0;
    if (!touches && bound == 0) continue;
    Matrix3d hessian = Matrix3d::Zero();
    if (touches) {
      hessian += row.stiffness * contact.normal * contact.normal.transpose();
      if (!semidefinite) hessian -= contact.pressing * contact.curvature;
    }
    if (bound > 0) hessian += sticking_hessian(contact.tangential, bound, row.sliding, row.normal);
    const ContactPoint& point = point_of(row);
    const double reach = reach_of(contact, placed);
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        if (const double weight = point.weights[a] * point.weights[b]; weight > 0)
          blocks.push_back({point.vertices[a], point.vertices[b], weight * hessian, reach});
  }
  return blocks;
}

ContactMemory ContactEnergy::memory_after(const VectorXd& u, double share) const {
  ContactMemory memory(slots_);
  pairs_.remember(u, share, memory);
  for (const Row& row : rows_) {
    const Piece& placed = piece_of(row);
    const Contact contact = contact_of(row, u);
    ContactForce& force = memory[memory_row(row)];
    force.normal = kept_force(contact.pressing, row.before, share, row.stiffness);
    if (row.before > 0)
      force.friction = placed.pose.axes.transpose() * within(contact.tangential, placed.friction * force.normal);
  }
  return memory;
}

std::vector<BodyContact> ContactEnergy::of_bodies(const std::vector<std::uint32_t>& bodies, const VectorXd& u) const {
  std::vector<BodyContact> contacts;
  contacts.reserve(rows_.size());
  pairs_.append_to(contacts, bodies, u);
  for (const Row& row : rows_) {
    const Piece& placed = piece_of(row);
    const Contact contact = contact_of(row, u);
    contacts.push_back({{bodies[point_of(row).vertices[0]], BodyContact::kTool},
                        {contact.x, contact.x},
                        contact.normal,
                        row.stiffness,
                        row.before,
                        contact.depth,
                        row.normal,
                        contact.tangential,
                        row.sliding,
                        placed.friction * row.before});
  }
  return contacts;
}

std::vector<ToolLoad> ContactEnergy::loads(const VectorXd& u) const {
  std::vector<ToolLoad> loads(model_.tools.size());
  for (const Row& row : rows_) {
    const Piece& placed = piece_of(row);
    const Contact contact = contact_of(row, u);
    const double bound = placed.friction * row.before;
    if (contact.pressing == 0 && bound == 0) continue;
    ToolLoad& load = loads[surface_.pieces[row.piece].tool];
    const Vector3d force = contact.pressing * contact.normal + within(contact.tangential, bound);
    load.force += force;
    load.torque += (contact.x - placed.origin).cross(force);
    if (contact.pressing == 0) continue;
    load.normal += contact.pressing;
    ++load.points;
    load.deepest = std::max(load.deepest, contact.depth);
  }
  return loads;
}

}  // namespace fascia
