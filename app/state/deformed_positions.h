// The current shape of the tissue on the CPU, for tools of the mouse.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "app/session/session.h"

namespace fascia {

/// Positions of the vertices of tets and drawn surface [m], as session.surface() numbers them. Waits for the GPU: call
/// it when a button is pressed, not in every frame.
std::vector<Eigen::Vector3d> deformed_positions(Session& session);

}  // namespace fascia
