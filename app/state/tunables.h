// Everything that a user can turn while a scene is simulated, as one value: what undo goes back to, what two sides of a
// comparison differ in. The camera is no tunable.
#pragma once
#include <string>
#include <vector>

#include "app/session/session.h"
#include "sim/grab/interactive_grab.h"
#include "sim/simulation/scene_edits.h"

namespace fascia {

struct Tunables {
  SolverSettings solver;
  std::vector<MaterialEntries> materials;  // [bodies]
  Eigen::Vector3d gravity{0, 0, 0};        // [m/s^2]
  DisplaySettings display;
  GrabSettings grab;
  bool operator==(const Tunables&) const = default;
};

Tunables tunables_of(const Session& session, const GrabSettings& grab);

/// Sets what differs, through the session's own setters, so that replays hear of it. Throws Error as they do.
void set_tunables(Session& session, GrabSettings& grab, const Tunables& tunables);

/// What changed from one to the other, for people: "Young's modulus, tumour: 10 kPa to 12 kPa". One line per change.
std::vector<std::string> changes(const Tunables& from, const Tunables& to);

}  // namespace fascia
