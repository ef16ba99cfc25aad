// The state that a scene begins with, where bodies may lie on tools.
#pragma once
#include "sim/model/state.h"

namespace fascia {

struct Model;

/// initial_state() with the forces of tools that carry bodies which nothing holds and which lie on them: friction goes
/// by the forces of the step before, and a body that begins on the ground with a speed would slide on without any for a
/// step. The forces are those on a rigid body at rest on springs, one for each point that touches (Winkler 1867), with
/// the penalties of points as their stiffness, and without friction: on a level face they add up to the body's weight.
/// A point touches that is no farther from a tool than a thousandth of the surface's mean edge, and does not leave it.
///
/// A body that tools squeeze, with points deeper than that, begins with forces of about its own stiffness, so that
/// friction holds it: (lambda_L + 2 mu_L) A d / L with the depth d, the area A and the body's radius L, of a rigid body
/// that comes to rest between them. Weight is not counted. From a single tool, which pushes it out, it has none.
State first_state(const Model& model);

}  // namespace fascia
