// Cases with initial states from which the body must return to rest.
#include <random>

#include "app/stress/case_maker.h"

namespace fascia {

using Eigen::Vector3d;

void add_starts(StressCases& c) {
  for (const double young : {1e6, 1e9}) {
    Scene s = c.beam_scene();
    s.bodies[0].material.young_modulus = young;
    const auto begin = [&](const std::string& name, const std::function<Vector3d(const Vector3d&)>& place) {
      StressCase& made = c.add("start", name + " E=" + in_short(young), s, c.start(s, place), 150);
      made.criteria.recovers = true;
      made.criteria.farthest = 6;  // random places are up to two sizes away initially
    };
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    begin("random", [&](const Vector3d&) -> Vector3d {
      const double x = uniform(random), y = uniform(random), z = uniform(random);
      return Vector3d(0.5 * kBarLength, 0.5 * kBarWidth, 0.5 * kBarWidth) + kBarLength * Vector3d(x, y, z);
    });
    begin("flattened", [](const Vector3d& x) { return Vector3d(x.x(), 0.5 * kBarWidth, x.z()); });
    begin("collapsed to a point",
          [](const Vector3d&) { return Vector3d(0.5 * kBarLength, 0.5 * kBarWidth, 0.5 * kBarWidth); });
    begin("mirrored", [](const Vector3d& x) { return Vector3d(-x.x(), x.y(), x.z()); });
    begin("half mirrored", [](const Vector3d& x) {
      return Vector3d(x.x() > 0.5 * kBarLength ? kBarLength - x.x() : x.x(), x.y(), x.z());
    });
  }
}

}  // namespace fascia
