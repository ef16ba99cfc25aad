// Converts solver settings of the public interface to the library's own, and back.
#pragma once
#include "fascia/settings.h"
#include "sim/scene/settings/solver_settings.h"

namespace fascia::api {

/// Throws Error "settings.iterations: ..." for a value out of range or an invalid solver choice.
SolverSettings checked(const Settings& settings);
Settings shown(const SolverSettings& settings);

}  // namespace fascia::api
