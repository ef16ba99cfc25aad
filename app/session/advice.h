// Hints beside a field: a likely problem, its cause, and a remedy. Unobtrusive, and removed permanently once dismissed.
#pragma once
#include <optional>
#include <set>
#include <string>

#include "sim/gpu/readback/diagnostics.h"
#include "sim/model/model.h"
#include "sim/scene/settings/solver_settings.h"

namespace fascia {

struct Hint {
  std::string name;    // identifies dismissed hints: "locking"
  std::string text;    // one line or two
  std::string help;    // the longer form, as a tooltip
  std::string remedy;  // label of a button; empty: none
  bool quiet = false;  // information rather than a warning: drawn dim
};

/// The dismissed hints, stored by the window.
struct HintBoard {
  std::set<std::string> dismissed;
};

/// Of a body of linear tets; `remedy`: whether quadratic elements can be offered.
std::optional<Hint> locking_hint(double poisson_ratio, bool remedy);
/// A hint for sizes that are not those of tissue [m], with the scale that would correct them.
struct UnitHint {
  Hint hint;
  double scale;
};
std::optional<UnitHint> unit_hint(const Scene& scene, const Model& model);
/// A hint based on the residual after the last step.
std::optional<Hint> iterations_hint(const SolverSettings& settings, const std::optional<Diagnostics>& diagnostics);
std::optional<Hint> time_step_hint(const SolverSettings& settings);

/// Draws the hint, unless it was dismissed. True if its remedy was pressed.
bool hint_row(HintBoard& board, const std::optional<Hint>& hint);

}  // namespace fascia
