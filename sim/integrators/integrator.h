// Time integrators: one table, with names and help, and the stages that each cuts a substep into.
//
//   implicit_euler  l = h                    first order; damps motion of period T by about 2 pi^2 h / T a period
//   bdf2            l = 2 h/3, p = 1/3       second order (Curtiss, Hirschfelder 1952); for h that changes by a factor
//                                            r: l = h (1 + r)/(1 + 2r), p = r^2/(1 + 2r). Without an earlier substep
//                                            r = 0, which is implicit Euler.
//   sdirk2          l = g h twice, p = 0 and then 1/g - 2, with g = 1 - 1/sqrt 2    second order, L-stable (Alexander
//                                            1977)
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "sim/integrators/stage.h"

namespace fascia {

enum class Integrator { implicit_euler, bdf2, sdirk2 };

struct IntegratorInfo {
  Integrator integrator;
  const char *name, *label, *help;  // in scene files; in menus; description with cost and limits
  int stages;                       // per substep
  bool extrapolates;                // whether a stage reads earlier displacements and velocities
  bool multistep;                   // whether those are of an earlier substep
};

const std::vector<IntegratorInfo>& integrators();  // in the order of the menu
const IntegratorInfo& info_of(Integrator integrator);
inline const char* name_of(Integrator integrator) { return info_of(integrator).name; }
inline const char* label_of(Integrator integrator) { return info_of(integrator).label; }
inline const char* help_of(Integrator integrator) { return info_of(integrator).help; }
std::optional<Integrator> find_integrator(std::string_view name);

/// The stages of a substep of length h [s]. `earlier`: length of the substep before, whose start is known [s]; 0: there
/// is none, as after a reset.
std::vector<IntegratorStage> stages_of(Integrator integrator, double h, double earlier);

}  // namespace fascia
