// Lists widgets without an explanation that the panels have drawn so far, for a test.
#pragma once
#include <set>
#include <string>

namespace fascia::ui {

/// Labels of widgets that were drawn without a tooltip: an error of their panel.
const std::set<std::string>& unexplained();
/// Call for every widget that is drawn.
void expect_help(const char* label, const std::string& help);

}  // namespace fascia::ui
