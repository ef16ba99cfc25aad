// fascia bench elements: a surface filled with linear tets against fewer quadratic ones whose steps take as long.
// Errors of equilibrium and motion are those of the mesh alone, against a far finer quadratic fill with the same
// supports, time steps and iterations.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "sim/scene/scene.h"

namespace fascia {

struct FilledCase {
  std::filesystem::path surface;
  double poisson_ratio = 0.3;
  std::optional<int> linear, quadratic, truth;  // resolutions; absent: the default, as fast, far finer
};

struct FilledPoint {
  ElementOrder elements = ElementOrder::linear;
  int resolution = 0;
  std::size_t vertices = 0, tets = 0;
  double volume = 0;                               // of the tets [m^3]
  double ms = 0;                                   // of a step, median
  double static_error = 0, motion_error = 0;       // relative, RMS over vertices of the truth
  double free_error = 0;                           // of the motion without supports
  double least_det = 1, least_det_at_corners = 1;  // J under a hand that pulls and lets go, over all steps
};

/// Linear, quadratic, and the truth, whose errors are 0 and whose hand is not measured. Throws Error or Interrupted.
std::vector<FilledPoint> compare_elements(const Bench& bench, const FilledCase& wanted);

/// Writes elements.csv for these surfaces, by default some of those of fascia bench fill, whose .obj files are left in
/// the folder.
/// `resolutions`: linear, quadratic and truth, or none.
void bench_elements(Bench& bench, std::vector<std::filesystem::path> surfaces, const std::vector<int>& resolutions);

}  // namespace fascia
