// Advice beside the field that it is about: what is likely wrong, why, and what to do. Quiet, and gone for good once
// clicked away.
#pragma once
#include <optional>
#include <set>
#include <string>

#include "sim/gpu/readback/diagnostics.h"
#include "sim/model/model.h"
#include "sim/scene/settings/solver_settings.h"

namespace fascia {

struct Hint {
  std::string name;    // says which was clicked away: "locking"
  std::string text;    // one line or two
  std::string help;    // the longer form, when the mouse is on it
  std::string remedy;  // of a button; empty: none
};

/// Of the window: which hints nobody wants to see again.
struct HintBoard {
  std::set<std::string> dismissed;
};

std::optional<Hint> locking_hint(double poisson_ratio);
/// For sizes that are no tissue's [m], with the scale that would make them so.
struct UnitHint {
  Hint hint;
  double scale;
};
std::optional<UnitHint> unit_hint(const Scene& scene, const Model& model);
/// From the residual that the last step was left with.
std::optional<Hint> iterations_hint(const SolverSettings& settings, const std::optional<Diagnostics>& diagnostics);
std::optional<Hint> time_step_hint(const SolverSettings& settings);

/// Draws it, unless it was clicked away. True when its remedy was pressed.
bool hint_row(HintBoard& board, const std::optional<Hint>& hint);

}  // namespace fascia
