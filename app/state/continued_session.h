// Solvers are built for their fixed vertices, regions and elements. A change of these makes a new session, which
// continues from the state of the old one.
#pragma once
#include <memory>

#include "app/session/session.h"

namespace fascia {

/// A session of `scene`, which differs from that of `old` in its fixed vertices, regions, elements or materials. Fixed
/// vertices are where they are at rest; all others, the camera and the clock are as in `old`. Throws Error.
std::unique_ptr<Session> continued_session(Graphics& graphics, Session& old, Scene scene);

}  // namespace fascia
