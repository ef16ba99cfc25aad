// fascia bench accuracy against the continuum: what a millisecond per step buys, over elements, integrators, iterations
// and meshes.
#pragma once
#include <vector>

#include "app/bench/bench.h"
#include "sim/model/model.h"

namespace fascia {

struct ContinuumChoice {
  ElementOrder elements = ElementOrder::linear;
  int cells = 8;  // of the beam along its length, a quarter of them across
  Integrator integrator = Integrator::implicit_euler;
  int iterations = 10;
};

struct ContinuumGrid {
  std::vector<int> linear_cells, quadratic_cells, iterations;
  std::vector<double> poisson_ratios;
  int truth_cells, truth_substeps;  // of quadratic tets, BDF2

  std::vector<ContinuumChoice> choices() const;
};
ContinuumGrid continuum_grid(bool quick);

struct ContinuumPoint {
  ContinuumChoice choice;
  double poisson_ratio = 0.3;
  std::size_t vertices = 0, tets = 0;
  double ms = 0;     // of a step, median
  double error = 0;  // of the motion, relative
};

/// Writes continuum.csv and continuum.md, a chart of each Poisson's ratio, and continuum_static.csv. Throws Error or
/// Interrupted.
std::vector<ContinuumPoint> bench_continuum(Bench& bench, const ContinuumGrid& grid);

}  // namespace fascia
