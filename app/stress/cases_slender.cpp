// Slender, nearly incompressible bodies: pulled by three hands at once and let go, and at rest.
#include <cmath>

#include "app/stress/case_maker.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/model/model.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kTrunkLength = 0.15, kTrunkWidth = 0.015;  // [m]
constexpr double kTrunkModulus = 1e7;                       // [Pa]

TetMesh trunk(bool quick) {
  TetMesh mesh = make_box(quick ? 20 : 40, quick ? 2 : 3, quick ? 2 : 3, {kTrunkLength, kTrunkWidth, kTrunkWidth});
  deform(mesh, [](const Vector3d& x) -> Vector3d {
    const double taper = 1 - 0.6 * x.x() / kTrunkLength;
    return {x.x(), taper * (x.y() - 0.5 * kTrunkWidth), taper * (x.z() - 0.5 * kTrunkWidth)};
  });
  return mesh;
}

Scene trunk_scene(const StressCases& c) {
  Scene s = c.scene("trunk", trunk(c.quick));
  s.bodies[0].material.young_modulus = kTrunkModulus;
  s.bodies[0].material.poisson_ratio = 0.49;
  s.bodies[0].material.damping = 0.02;
  return s;
}

// Springs of a hand on the vertices within a width of a place along the trunk.
void grip(const Model& built, double place, const Vector3d& offset, GrabInput& springs) {
  const std::size_t begin = springs.size();
  for (std::uint32_t v = 0; v < built.rest_positions.size(); ++v)
    if (std::abs(built.rest_positions[v].x() - place) < 0.5 * kTrunkWidth) springs.push_back({v, offset, 0});
  const double stiffness = 3 * kTrunkModulus * 0.5 * kTrunkWidth;
  for (std::size_t k = begin; k < springs.size(); ++k)
    springs[k].stiffness = stiffness / static_cast<double>(springs.size() - begin);
}

}  // namespace

void add_slender(StressCases& c) {
  if (!carries(c.pair.method, kTissueLaw)) return;
  constexpr long kPulled = 60, kHeld = 100, kEnd = 500;  // steps: to the farthest, to the release, 6.7 s after it
  Scene s = trunk_scene(c);
  const Model built = build_model(s);
  StressCase& made = c.add("slender", "trunk with three hands", s, std::nullopt, kEnd);
  for (long step = 0; step < kHeld; ++step) {
    const double share = std::min(1.0, static_cast<double>(step) / kPulled);
    GrabInput springs;
    grip(built, 0.4 * kTrunkLength, share * 0.08 * Vector3d(0, 1, 0.4), springs);
    grip(built, 0.7 * kTrunkLength, share * 0.12 * Vector3d(-0.6, -1, 0.2), springs);
    grip(built, kTrunkLength, share * 0.15 * Vector3d(-0.8, 0.3, -1), springs);
    made.replay.inputs.push_back({step, std::move(springs)});
  }
  made.replay.inputs.push_back({kHeld, GrabInput{}});
  made.criteria.recovers = made.criteria.springs_back = true;

  for (const double ratio : {0.49, 0.499}) {
    Scene still = trunk_scene(c);
    still.bodies[0].material.poisson_ratio = ratio;
    still.gravity = {0, -9.81, 0};
    c.add("slender", "trunk at rest nu=" + in_short(ratio), still, std::nullopt, 300).criteria.carries_its_weight =
        true;
  }
}

}  // namespace fascia
