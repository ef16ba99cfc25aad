// Changes which vertices of an open scene are fixed.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "sim/model/model.h"

namespace fascia {

/// "fixed" of every body of a scene [bodies].
using FixedSets = std::vector<std::vector<Selection>>;

FixedSets fixed_of(const Scene& scene);
/// The current sets with these vertices of the model fixed, or released. A body whose vertices change gets one list of
/// vertices in place of its selections; the others keep theirs. Vertices with a prescribed motion are left out.
FixedSets with_fixed(const Scene& scene, const Model& model, std::span<const std::uint32_t> vertices, bool fix);

}  // namespace fascia
