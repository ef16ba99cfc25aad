// Marks of instruments over the picture: the force of each that touches, and where the hand wants the one it holds.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/overlay/grab_marks.h"

namespace fascia {

struct InstrumentMark {
  Eigen::Vector3d at{0, 0, 0};               // of the label [m]
  std::optional<double> force;               // [N]; none: it touches nothing
  std::optional<Eigen::Vector3d> commanded;  // where the hand wants the place `at`; none: not in hand
  bool waits = false;                        // at tissue that is crushed
};

/// `loads`: [tool], possibly empty. `commanded`, `waits`: of the tool `picked`.
std::vector<InstrumentMark> instrument_marks(const Simulation& simulation, const std::vector<ToolLoad>& loads,
                                             std::optional<std::size_t> picked,
                                             const std::optional<ToolPlace>& commanded, bool waits);
void draw_instrument_marks(const MarkArea& area, const Session& session, const std::vector<InstrumentMark>& marks,
                           LabelPlaces& places);

}  // namespace fascia
