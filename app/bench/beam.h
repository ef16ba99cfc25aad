// The beam of figures 2 to 4: one mesh, one support, one bent and twisted initial state.
#pragma once
#include <vector>

#include "app/bench/bench.h"
#include "sim/reference/newton.h"

namespace fascia {

/// A box of 1 m x 0.25 m x 0.25 m, clamped at x = 0, under gravity; density 1000, Poisson's ratio 0.3. Writes the mesh
/// beam.msh into the output folder. `young_modulus` [Pa].
Scene beam_scene(const Bench& bench, double young_modulus, const SolverSettings& settings);

/// The vertices of the free end, x = 1 m.
std::vector<std::uint32_t> beam_tip(const Model& model);

/// Sum over the vertices of |a - b|^2.
double squared_distance(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b);

/// At rest in a smooth bend and twist whose curvatures grow along x from zero at the clamped end: an RMS strain of
/// about 0.1. Rounded to float32, so that both solvers start from the same numbers.
State bent_beam(const Model& model);

}  // namespace fascia
