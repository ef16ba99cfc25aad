#include "app/cli/discretization.h"

#include <algorithm>

namespace fascia {

std::optional<ElementOrder> Discretization::elements() const {
  const auto found = std::find_if(kElementOrders.begin(), kElementOrders.end(),
                                  [&](ElementOrder order) { return name_of(order) == elements_name; });
  return found == kElementOrders.end() ? std::nullopt : std::optional(*found);
}

void add_discretization(CLI::App& command, Discretization& names, const std::string& of_what) {
  std::vector<std::string> integrator_names, element_names;
  for (const IntegratorInfo& info : integrators()) integrator_names.emplace_back(info.name);
  for (const ElementOrder order : kElementOrders) element_names.emplace_back(name_of(order));
  add_choice(command, "--integrator", names.integrator_name, integrator_names, "time integrator " + of_what)
      ->capture_default_str();
  add_choice(command, "--elements", names.elements_name, element_names, "elements " + of_what)->capture_default_str();
}

}  // namespace fascia
