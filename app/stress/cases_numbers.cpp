// Cases with numbers at the ends of their ranges.
#include <cmath>

#include "app/stress/case_maker.h"
#include "sim/model/model.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// Released from a bent state, under gravity: the base case, in which one number at a time is set to the ends of its
// range.
StressCase& released(StressCases& c, const std::string& group, const std::string& name, Scene scene, long steps) {
  scene.gravity = {0, -9.81, 0};
  std::optional<State> state = c.bent(scene);
  StressCase& made = c.add(group, name, std::move(scene), std::move(state), steps);
  made.criteria.creates_no_energy = true;
  return made;
}

}  // namespace

void add_numbers(StressCases& c) {
  for (const double young : {1e2, 1e4, 1e6, 1e8, 1e10}) {
    Scene s = c.beam_scene();
    s.bodies[0].material.young_modulus = young;
    StressCase& made = released(c, "number", "E=" + in_short(young), s, 90);
    // Material of 100 Pa is too soft for a beam: its own weight pulls it down by many times its length.
    if (young < 1e4) made.criteria.farthest = 100;
    made.criteria.keeps_upright = young >= 1e4;
  }
  for (const double ratio : {-0.9, 0.0, 0.3, 0.49, 0.499}) {
    Scene s = c.beam_scene();
    s.bodies[0].material.poisson_ratio = ratio;
    released(c, "number", "nu=" + in_short(ratio), s, 90);
  }
  for (const int rate : {15, 60, 250, 1000}) {
    Scene s = c.beam_scene();
    s.solver.time_step = 1.0 / rate;
    released(c, "number", "h=1/" + std::to_string(rate), s, rate < 100 ? 90 : 250);
  }
  for (const int iterations : {1, 5, 20, 100}) {
    Scene s = c.beam_scene();
    s.solver.iterations = iterations;
    released(c, "number", "iterations=" + std::to_string(iterations), s, iterations > 50 ? 60 : 90);
  }
  const auto halves = [&](const char* name, int steps, const std::function<void(Body&, MaterialOverride&)>& change) {
    TetMesh mesh = c.beam();
    mesh.regions.assign(mesh.tets.size(), 1);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      Vector3d center = Vector3d::Zero();
      for (const std::uint32_t v : mesh.tets[t]) center += 0.25 * mesh.positions[v];
      if (std::fmod(center.x() / kBarLength, 0.5) > 0.25) mesh.regions[t] = 2;
    }
    Scene s = c.scene("layers", mesh);
    change(s.bodies[0], s.bodies[0].region_materials.emplace_back("2", MaterialOverride{}).second);
    return released(c, "number", name, s, steps);
  };
  // The weight of the beam would crush soft layers of 10 kPa in the exact solution, too. The stiff layers invert these,
  // and in the exact solution, too, some of their tets still are inverted after 90 steps; with
  // signed_st_venant_kirchhoff none after 180, with squared none after 360.
  halves("layers of E 1:1e6", 360, [](Body& body, MaterialOverride& m) {
    body.material.young_modulus = 3e4;
    m.young_modulus = 3e10;
  });
  halves("densities 1:1e4", 90, [](Body& body, MaterialOverride& m) {
    body.material.density = 100;
    m.density = 1e6;
  });
}

}  // namespace fascia
