// --integrator and --elements: how a command discretizes the motions that it runs.
#pragma once
#include <optional>
#include <string>

#include "app/cli/command_line.h"
#include "sim/scene/scene.h"

namespace fascia {

struct Discretization {
  std::string integrator_name, elements_name;  // as typed; empty: none

  std::optional<Integrator> integrator() const { return find_integrator(integrator_name); }
  std::optional<ElementOrder> elements() const;
};

/// `of_what`: "of all cases". Names that are not empty are the defaults.
void add_discretization(CLI::App& command, Discretization& names, const std::string& of_what);

}  // namespace fascia
