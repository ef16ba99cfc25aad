// What the panels drew so far that nothing explains, for the test that looks for it.
#pragma once
#include <set>
#include <string>

namespace fascia::ui {

/// Labels of widgets that were drawn without a text to explain them: a fault of their panel.
const std::set<std::string>& unexplained();

}  // namespace fascia::ui
