// A measurement as samples, so that plots show it beside the simulated ones.
#pragma once
#include <vector>

#include "sim/fit/measured/measurement.h"
#include "sim/output/sample.h"

namespace fascia {

/// A sample for each time of the measurement's curves, ascending, unknown but for what was measured: reaction, grab,
/// the forces of the `tools` of a model, and the displacement of `probe`. Of a vector with a measured component, others
/// are zero; those of a displacement stay unknown. Curves without times and of other vertices are left out.
std::vector<Sample> measured_samples(const Measurement& measurement, std::size_t tools, std::uint32_t probe);

}  // namespace fascia
