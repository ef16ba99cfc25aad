// Changes which vertices of an open scene are fixed. Solvers are built for their fixed vertices, so a change makes a
// new session, which continues from the state of the old one.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "app/session/session.h"

namespace fascia {

/// "fixed" of every body of a scene [bodies].
using FixedSets = std::vector<std::vector<Selection>>;

FixedSets fixed_of(const Scene& scene);
/// The current sets with these vertices of the model fixed, or released. A body whose vertices change gets one list of
/// vertices in place of its selections; the others keep theirs. Vertices with a prescribed motion are left out.
FixedSets with_fixed(const Scene& scene, const Model& model, std::span<const std::uint32_t> vertices, bool fix);

/// A session of `scene`, which differs from that of `old` in its fixed vertices. Fixed vertices are where they are at
/// rest, all others, the camera and the clock are as in `old`. Throws Error.
std::unique_ptr<Session> session_with_fixed(Graphics& graphics, Session& old, Scene scene);

}  // namespace fascia
