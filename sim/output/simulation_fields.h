// The fields of a simulation that an export contains.
#pragma once
#include <filesystem>

#include "sim/simulation/simulation.h"

namespace fascia {

/// Of `state`, which is that of the simulation after its last step, for a file of this name: without the recovered
/// stress if its format has none. Forces of contact are those of that step; waits for the GPU.
StateFields export_fields(const Simulation& simulation, const State& state, const std::filesystem::path& path);

}  // namespace fascia
