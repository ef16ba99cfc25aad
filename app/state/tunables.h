// All parameters that a user can change during a simulation, as one value: undo restores it, and the two sides of a
// comparison differ in it. The camera is not included.
#pragma once
#include <string>
#include <vector>

#include "app/session/session.h"
#include "app/state/element_orders.h"
#include "app/state/fixed_vertices.h"
#include "app/state/painted_regions.h"
#include "sim/grab/interactive_grab.h"
#include "sim/simulation/scene_edits.h"

namespace fascia {

struct Tunables {
  SolverSettings solver;
  std::vector<MaterialEntries> materials;  // [bodies]
  FixedSets fixed;                         // set_tunables() sets neither this
  RegionSets regions;                      // nor this
  ElementOrders elements;                  // nor this: they take another session
  std::vector<Instrument> instruments;     // nor this
  Eigen::Vector3d gravity{0, 0, 0};        // [m/s^2]
  DisplaySettings display;
  GrabSettings grab;
  bool operator==(const Tunables&) const = default;
};

Tunables tunables_of(const Session& session, const GrabSettings& grab);

/// Sets the parameters that differ, except `fixed`, `regions`, `elements` and `instruments`, through the session's own
/// setters, so that replays record them. Throws Error as they do.
void set_tunables(Session& session, GrabSettings& grab, const Tunables& tunables);

/// The changes from one to the other as text: "Young's modulus, tumour: 10 kPa to 12 kPa". One line per change.
std::vector<std::string> changes(const Tunables& from, const Tunables& to);

}  // namespace fascia
