// Beams whose end is pulled through their foot and let go: tissue that was pulled through itself has to come apart.
#include <cmath>
#include <numbers>

#include "app/stress/case_maker.h"
#include "sim/grab/build_model.h"
#include "sim/model/model.h"

namespace fascia {

using Eigen::Vector3d;

void add_tangles(StressCases& c) {
  if (!carries(c.pair.method, kTissueLaw)) return;
  constexpr int kDirections = 12;
  constexpr long kPulled = 60, kHeld = 80, kEnd = 500;  // steps: to the farthest, to the release, 7 s after it
  const Scene s = c.beam_scene();
  const Model built = build_model(s);
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2 * std::numbers::pi * k / kDirections, aside = 0.05 * kBarLength;
    const Vector3d farthest(-2 * kBarLength, aside * std::cos(angle), aside * std::sin(angle));
    StressCase& made = c.add("tangles", "pulled through the foot " + std::to_string(k), s, std::nullopt, kEnd);
    for (long step = 0; step < kHeld; ++step)
      made.replay.inputs.push_back(
          {step, grip_end(built, std::min(1.0, static_cast<double>(step) / kPulled) * farthest)});
    made.replay.inputs.push_back({kHeld, GrabInput{}});
    made.criteria.recovers = made.criteria.springs_back = true;
  }
}

}  // namespace fascia
