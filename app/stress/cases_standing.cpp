// Bodies that stand on a clamped foot under their own weight, from light to as heavy as their stiffness carries.
#include <cmath>

#include "app/stress/case_maker.h"
#include "sim/mesh/mesh_generate.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kHeight = 0.4;  // [m]

TetMesh cube(bool quick) {
  const int cells = quick ? 3 : 6;
  return make_box(cells, cells, cells, {kHeight, kHeight, kHeight});
}

// A cube whose horizontal sections become discs that shrink to a fifth at the top.
TetMesh cone(bool quick) {
  TetMesh mesh = cube(quick);
  deform(mesh, [](const Vector3d& x) -> Vector3d {
    const double a = 2 * x.x() / kHeight - 1, b = 2 * x.z() / kHeight - 1, radius = 0.4 * (1 - 0.8 * x.y() / kHeight);
    return {radius * kHeight * a * std::sqrt(1 - b * b / 2), x.y(), radius * kHeight * b * std::sqrt(1 - a * a / 2)};
  });
  return mesh;
}

// From a weight of 0.65 on a cube buckles, topples over its foot and hangs beside it, since nothing else carries it. It
// swings for some seconds.
constexpr long kSteps = 900;

// `weight`: rho g height / E, the strain that the whole weight would cause at the foot.
void standing(StressCases& c, const std::string& shape, const TetMesh& mesh, double weight, double ratio) {
  Scene s = c.scene(shape, mesh, false);
  s.bodies[0].fixed.push_back(BoxSelection{{-1, -kNearFace, -1}, {1, kNearFace, 1}});
  s.gravity = {0, -9.81, 0};
  Material& material = s.bodies[0].material;
  material.young_modulus = material.density * 9.81 * kHeight / weight;
  material.poisson_ratio = ratio;
  material.damping = 0.02;
  StressCase& made = c.add("standing", shape + " w=" + in_short(weight) + " nu=" + in_short(ratio), std::move(s),
                           std::nullopt, kSteps);
  made.criteria.carries_its_weight = true;
}

}  // namespace

void add_standing(StressCases& c) {
  // A law that softens under compression lets the heavy ones collapse, whatever the method.
  if (!carries(c.pair.method, kTissueLaw)) return;
  const std::vector<double> ratios = c.quick ? std::vector{0.0, 0.3, 0.49} : std::vector{0.0, 0.15, 0.3, 0.45, 0.49};
  for (const double weight : {0.4, 0.6, 0.8, 1.0})
    for (const double ratio : ratios) {
      standing(c, "cube", cube(c.quick), weight, ratio);
      standing(c, "cone", cone(c.quick), weight, ratio);
    }
}

}  // namespace fascia
