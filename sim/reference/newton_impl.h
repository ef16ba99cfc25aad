// The state of a NewtonSolver between its calls, and what time steps (newton.cpp) and static equilibria
// (static_search.cpp) have in common.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "sim/contact/contact_energy.h"
#include "sim/contact/pair_search.h"
#include "sim/contact/passing/clear_way.h"
#include "sim/contact/row_stiffness.h"
#include "sim/contact/step_loads.h"
#include "sim/model/unconstrained_parts.h"
#include "sim/reference/held_path.h"
#include "sim/reference/minimizer.h"
#include "sim/reference/newton.h"

namespace fascia::reference {

inline constexpr int last_patience = 400;            // Newton iterations, if no smaller increment can be tried
inline constexpr double increment_tolerance = 1e-6;  // of intermediate equilibria, which only start the next increment

/// [3 * vertex_count] each value of a vertex three times.
inline Eigen::VectorXd per_component(const std::vector<double>& per_vertex) {
  Eigen::VectorXd all(3 * per_vertex.size());
  for (std::size_t v = 0; v < per_vertex.size(); ++v) all.segment<3>(3 * v).setConstant(per_vertex[v]);
  return all;
}

/// Adds the energy of the spring. The sum of two parabolas is a parabola.
inline void add(const GrabSpring& spring, Potential& potential) {
  const Eigen::Index i = 3 * static_cast<Eigen::Index>(spring.vertex);
  const double inertia = potential.inertia[i], sum = inertia + spring.stiffness;
  if (sum == 0) return;
  potential.target.segment<3>(i) = (inertia * potential.target.segment<3>(i) + spring.stiffness * spring.target) / sum;
  potential.inertia.segment<3>(i).setConstant(sum);
}

struct NewtonSolver::Impl {
  Impl(const Model& m, const SolverSettings& s, std::stop_token token)
      : model(m),
        settings(s),
        stop(std::move(token)),
        system(model),
        minimizer(system),
        mass(per_component(lumped_masses(model))),
        moving(model),
        gravity(model.gravity.replicate(model.rest_positions.size(), 1)),
        weight(per_component(consistent_masses(model)).cwiseProduct(gravity)),
        size(flattened(model.rest_positions).maxCoeff() - flattened(model.rest_positions).minCoeff()),
        contact(make_contact_surface(model)),
        penalty(contact_stiffness(model, contact)),
        pairs(model),
        clear(model, contact, pairs.skin()),
        loads{std::vector<ToolLoad>(model.tools.size()), {}} {
    for (const std::uint32_t part : unconstrained_parts(model, model.held()).part) falls.push_back(part != 0);
  }

  NewtonReport solve(const IntegratorStage& stage, const ToolMotion& motion, State& state);
  bool touches() const { return !contact.empty() || !pairs.empty(); }
  /// Of a step from `start` under the forces in `memory`; `end`: where velocities lead, if anything `moves`.
  std::shared_ptr<const ContactEnergy> contact_from(const Eigen::VectorXd& start,
                                                    const std::vector<Eigen::Vector3d>& end,
                                                    const std::vector<double>& stiffness, const ToolMotion& motion,
                                                    ContactMemory& memory, const IntegratorStage* stage = nullptr,
                                                    double time = 0) {
    memory.resize(contact.row_count + pairs.row_count());
    const auto before = std::span<const ContactForce>(memory).subspan(contact.row_count);
    std::vector<Eigen::Vector3d> path = end;
    if (stage && stage_length != stage->length)
      in_stage = stage_stiffness(model, contact, stiffness, stage_length = stage->length);
    rows = row_stiffness(model, contact, stage ? in_stage : stiffness, memory, motion, as_vectors(start), end);
    if (!stage)
      return std::make_shared<ContactEnergy>(model, contact, rows, memory, start, motion,
                                             pairs.find(as_vectors(start), end, before));
    if (!pairs.empty()) {
      const std::vector<char> carried = pairs.carried(before, time);
      for (std::size_t v = 0; v < path.size(); ++v)
        if (falls[v] && carried[v]) path[v] -= fall_in(*stage);
    }
    return std::make_shared<ContactEnergy>(model, contact, rows, memory, start, motion,
                                           pairs.find(as_vectors(start), path, before, stage->length, time), end);
  }
  /// After pairs.misses().
  std::shared_ptr<const ContactEnergy> contact_again(const Eigen::VectorXd& start, const ToolMotion& motion,
                                                     const std::vector<Eigen::Vector3d>& aim, ContactMemory& memory) {
    std::vector<PairRow> found = pairs.find_again();
    for (const PairRow& row : found) memory[contact.row_count + force_row(row.slot)].normal = row.before;
    return std::make_shared<ContactEnergy>(model, contact, rows, memory, start, motion, std::move(found), aim);
  }
  Eigen::Vector3d fall_in(const IntegratorStage& stage) const {
    return stage.duration * stage.duration * model.gravity;
  }
  void read_out(std::shared_ptr<const ContactEnergy> energy, const Eigen::VectorXd& u) {
    loads = {energy->loads(u), energy->pairs().loads(u)};
    touched = std::move(energy);
    touched_at = u;
  }
  ToolMotion motion_within(double from, double to) const {
    return tools ? *tools : motion_on_paths(model.tools, from, to);
  }
  NewtonReport solve_static(State& state, double tolerance, std::optional<double> until);
  /// The equilibrium at `end`, by one problem whose tools are where `motion` ends, once the forces of contact change by
  /// no more than `steady` in a pass, relative to the largest one.
  NewtonReport equilibrium(State& state, double tolerance, double steady, double end, double moment,
                           const ToolMotion& motion);
  /// eps* [tet_count].
  std::vector<Eigen::Matrix3d> strains(const IntegratorStage& stage, const Eigen::VectorXd& now,
                                       const Eigen::VectorXd& earlier) const;

  /// Minimizes potential(1) with the constrained vertices at the end of their path, from `u`, by the largest increments
  /// of s in (0, 1] for which Newton's method converges with every tet upright. `divisible`: whether smaller increments
  /// are smaller problems.
  NewtonReport follow(const HeldPath& path, const std::function<Potential(double s)>& potential, bool divisible,
                      double tolerance, Eigen::VectorXd& u);

  /// Repeats the update of the multipliers in `memory` from the equilibrium `u` until the forces are `steady`, or
  /// change by no more than rounding. A body that only contact supports `lands` first: it falls without speed, for
  /// longer in every pass, so that its inertia vanishes.
  void settle_forces(Potential potential, const std::vector<double>& stiffness, const ToolMotion& motion, bool lands,
                     double tolerance, double steady, NewtonReport& report, ContactMemory& memory, Eigen::VectorXd& u);

  const Model& model;
  const SolverSettings settings;
  std::stop_token stop;
  std::vector<GrabSpring> springs;
  const ElasticSystem system;
  Minimizer minimizer;
  const Eigen::VectorXd mass;  // lumped [3 * vertex_count] [kg]
  const MassMatrix moving;
  const Eigen::VectorXd gravity, weight;  // [3 * vertex_count] [m/s^2], [N]
  const double size;                      // of the tissue [m]
  const ContactSurface contact;
  const std::vector<double> penalty;  // [contact.points] [N/m]
  std::vector<double> rows;           // row_stiffness() of the last contact_from()
  PairSearch pairs;
  ClearWay clear;
  std::vector<char> falls;       // [vertex] in unconstrained parts
  std::vector<double> in_stage;  // [point] the penalty in stages of `stage_length` [s]
  double stage_length = 0;
  std::optional<ToolMotion> tools;  // none: on their paths
  ContactLoads loads;
  std::shared_ptr<const ContactEnergy> touched;  // of the last step or solve, which ended at `touched_at`
  Eigen::VectorXd touched_at;                    // [3 * vertex_count] [m]
};

}  // namespace fascia::reference
