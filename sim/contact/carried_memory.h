// What contact remembers of a step, for the next one of a model with other tools: rows of tools and of the tissue
// follow one another, so that those behind a tool that comes or goes have other places.
#pragma once
#include "sim/model/model.h"
#include "sim/model/state.h"

namespace fascia {

/// `memory`: of a state of `before`. Tools that both models have by name, with as many contact points, keep theirs, and
/// so does the tissue. Nothing is remembered where the tissue itself, or what is held of it, differs.
ContactMemory carried_memory(const Model& before, const ContactMemory& memory, const Model& after);

}  // namespace fascia
