// fascia refine: from errors and times of trial runs to the cheapest choice of elements, mesh, integrator, substeps and
// iterations with a wanted error in a wanted time.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace fascia {

/// A run of one choice on the mesh at hand. Errors are relative to the displacements.
struct Trial {
  ElementOrder elements = ElementOrder::linear;
  Integrator integrator = Integrator::implicit_euler;
  std::size_t tets = 0;
  int substeps = 1;
  double mesh = 0, time = 0;               // estimated; time: over the run
  double order = 1;                        // at which the error in time falls with the substeps
  bool resolved = true;                    // TimeError::resolved
  int few = 5, many = 10;                  // iterations
  double solver_few = 0, solver_many = 0;  // of the whole run with these
  double ms_few = 0, ms_many = 0;          // of a step with these, medians

  double ns_per_tet_iteration() const;
};

struct Proposal {
  ElementOrder elements = ElementOrder::linear;
  Integrator integrator = Integrator::implicit_euler;
  double refinement = 1;  // edges are shorter by this factor
  double tets = 0;
  int substeps = 1, iterations = 10;
  double mesh = 0, time = 0, solver = 0;  // predicted
  double ms = 0;

  double error() const { return mesh + time + solver; }
};

/// What the trial becomes with finer edges, more substeps and other iterations:
///   mesh error * refinement^-2     the order of both elements in general; that of quadratic ones is up to 4
///   time error * substeps^-order   the order found, or kLeastOrder where it is less: such errors fall in shorter steps
///   solver error: geometric between the two measured numbers of iterations, and beyond them
///   time: tets and substeps times that of a tet in a substep, linear in the iterations through both measured times
Proposal predicted(const Trial& trial, double refinement, int substeps, int iterations);

struct Plan {
  std::optional<Proposal> within;  // the fastest one within error and time
  std::optional<Proposal> exact;   // the fastest one within the error, whatever it takes
  std::optional<Proposal> fast;    // the most accurate one within the time
};
/// `error`: relative. `ms`: of a step. Of trials that differ in their substeps alone, each choice follows from the one
/// with the most substeps of those that do not have more than it.
Plan plan_for(const std::vector<Trial>& trials, double error, double ms);

/// Whether a trial has the elements, the integrator and the substeps of the proposal.
bool measured(const Proposal& proposal, const std::vector<Trial>& trials);

}  // namespace fascia
