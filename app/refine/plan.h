// fascia refine: from errors and times of trial runs to the cheapest choice of elements, mesh, integrator, substeps and
// iterations with a wanted error in a wanted time.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace fascia {

/// A run of one choice. Errors are relative to the displacements, over the run.
struct Trial {
  ElementOrder elements = ElementOrder::linear;
  Integrator integrator = Integrator::implicit_euler;
  double refinement = 1;  // of its mesh: edges are shorter by this factor than those of the scene as opened
  std::size_t tets = 0;
  std::size_t kept = 0;  // of these: in bodies whose mesh stays as it is
  int substeps = 1;
  double shape = 0;                        // how far the volume of a filled surface is off, of the body farthest off
  double mesh = 0, time = 0;               // estimated
  double order = 1;                        // at which the error in time falls with the substeps
  bool resolved = true;                    // TimeError::resolved
  int few = 5, many = 10;                  // iterations
  double solver_few = 0, solver_many = 0;  // with these
  double ms_few = 0, ms_many = 0;          // of a step with these, medians

  double ns_per_tet_iteration() const;
};

struct Proposal {
  ElementOrder elements = ElementOrder::linear;
  Integrator integrator = Integrator::implicit_euler;
  double refinement = 1;  // as that of a trial
  double tets = 0;
  int substeps = 1, iterations = 10;
  double shape = 0, mesh = 0, time = 0, solver = 0;  // predicted
  double ms = 0;
  bool measured = false;    // by the trial, which has all five choices: numbers are those of a run
  bool other_mesh = false;  // than that of the trial: numbers are extrapolated from a mesh of so many tets
  std::size_t from_tets = 0;

  double error() const { return shape + mesh + time + solver; }
};

/// What the trial becomes on another mesh, with more substeps and other iterations:
///   mesh error * (refinement over the trial's)^-2     the order of both elements in general
///              * (refinement over the trial's)^-4     on coarser meshes of quadratic tets, whose order is up to that
///   shape error * (refinement over the trial's)^-2    a guess: it falls by leaps, and a run on the mesh tells
///   time error * substeps^-order   the order found, or kLeastOrder where it is less: such errors fall in shorter steps
///   solver error: geometric between the two measured numbers of iterations, and beyond them
///   time: tets and substeps times that of a tet in a substep, linear in the iterations through both measured times
/// With the trial's own choices, its numbers.
Proposal predicted(const Trial& trial, double refinement, int substeps, int iterations);

struct Plan {
  std::optional<Proposal> within;   // the fastest one within error and time
  std::optional<Proposal> exact;    // the fastest one within the error, whatever it takes
  std::optional<Proposal> fast;     // the most accurate one within the time
  std::optional<Proposal> best;     // the fastest one with the least error of all or a tenth more
  std::optional<Proposal> fastest;  // the fastest one of all
  bool cut_off = false;             // choices that no run has confirmed are left out (confirmed_plan.h)
};

/// The most that a choice may have.
constexpr int kMostSubsteps = 8, kMostIterations = 30;

/// Meshes with 1/16 to 512 times the tets of the one at hand, each with twice the tets of the one before.
std::vector<double> usual_refinements();

/// `error`: relative. `ms`: of a step. `refinements`: of meshes to choose from. A choice follows from the trial of its
/// elements and integrator that has the most substeps of those that do not have more than it; of several, from the one
/// with the nearest mesh, then with the nearest iterations; its error of shape, which is the same for all, from the
/// trial with the nearest mesh. A choice that no trial has is taken for better than one that a trial has only where it
/// promises a tenth more. Choices that `allowed` refuses are left out.
Plan plan_for(const std::vector<Trial>& trials, double error, double ms,
              const std::vector<double>& refinements = usual_refinements(),
              const std::function<bool(const Proposal&)>& allowed = {});

/// Whether a trial has the elements, the integrator, the mesh, the substeps and the iterations of the proposal.
bool measured(const Proposal& proposal, const std::vector<Trial>& trials);

}  // namespace fascia
