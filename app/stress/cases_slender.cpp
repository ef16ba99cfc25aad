// Slender, nearly incompressible bodies: pulled by three hands at once and let go, and at rest.
#include <array>
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

Scene trunk_scene(StressCases& c) {
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

// Three hands pull at the trunk, hold it and let go. `offsets` [m]: of the hand nearest to the root, of the middle one
// and of the one at the tip, at their farthest.
void with_hands(StressCases& c, const std::string& name, const std::array<Vector3d, 3>& offsets) {
  constexpr long kPulled = 60, kHeld = 100, kEnd = 500;  // steps: to the farthest, to the release, 6.7 s after it
  constexpr std::array<double, 3> kPlaces = {0.4, 0.7, 1};
  const Scene s = trunk_scene(c);
  const Model built = build_model(s);
  StressCase& made = c.add("slender", name, s, std::nullopt, kEnd);
  for (long step = 0; step < kHeld; ++step) {
    const double share = std::min(1.0, static_cast<double>(step) / kPulled);
    GrabInput springs;
    for (std::size_t k = 0; k < 3; ++k) grip(built, kPlaces[k] * kTrunkLength, share * offsets[k], springs);
    made.replay.inputs.push_back({step, std::move(springs)});
  }
  made.replay.inputs.push_back({kHeld, GrabInput{}});
  made.criteria.recovers = made.criteria.springs_back = true;
}

}  // namespace

void add_slender(StressCases& c) {
  if (!carries(c.pair.method, kTissueLaw)) return;
  with_hands(c, "trunk with three hands", {{{0, 0.08, 0.032}, {-0.072, -0.12, 0.024}, {-0.12, 0.045, -0.15}}});
  // On the small mesh signed_st_venant_kirchhoff leaves it inside out.
  with_hands(c, "trunk wound up", {{{0.073, 0.072, -0.071}, {-0.1, 0.08, 0.057}, {0.054, -0.061, 0.034}}});

  for (const double ratio : {0.49, 0.499}) {
    Scene still = trunk_scene(c);
    still.bodies[0].material.poisson_ratio = ratio;
    still.gravity = {0, -9.81, 0};
    c.add("slender", "trunk at rest nu=" + in_short(ratio), still, std::nullopt, 300).criteria.carries_its_weight =
        true;
  }
}

}  // namespace fascia
