// A column that is twisted by a quarter turn, and a nearly incompressible block between bonded plates.
#include <Eigen/LU>
#include <cmath>

#include "app/verify/solids.h"
#include "app/verify/verification.h"
#include "base/text.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/reference/newton.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

Selection slab(int axis, double at) {
  Vector3d low(-1, -1, -1), high(1, 1, 1);
  low[axis] = at - 1e-6;
  high[axis] = at + 1e-6;
  return BoxSelection{low, high};
}

Model twisted_column(int across, ElementOrder elements) {
  PrescribedMotion turn;
  turn.select = slab(1, 0.6);
  turn.axis = Vector3d::UnitY();
  turn.angle_deg = 90;
  turn.center = {0.05, 0, 0.05};
  return solid(make_box(across, 6 * across, across, {0.1, 0.6, 0.1}),
               material_of(MaterialModel::neo_hookean, 1e5, 0.45), elements, {slab(1, 0)}, {turn});
}

Model pressed_block(int cells, ElementOrder elements) {
  PrescribedMotion press;
  press.select = slab(1, 0.1);
  press.translate = {0, -0.015, 0};
  return solid(make_box(cells, cells, cells, {0.1, 0.1, 0.1}), material_of(MaterialModel::neo_hookean, 1e5, 0.499),
               elements, {slab(1, 0)}, {press});
}

}  // namespace

void verify_twist(Verification& verification) {
  const char* const kTest = "Twisting column";
  constexpr double kEnergy = 1.0055;  // [J]; 288 and 972 quadratic tets have 1.0434 J and 1.0155 J
  for (const ElementOrder elements : kElementOrders) {
    const bool quadratic = elements == ElementOrder::quadratic;
    const Model model = twisted_column(quadratic ? 3 : 6, elements);
    const State state = equilibrium(model);
    const reference::Measures measures = reference::measure(model, state);
    VerifiedNumber finding{kTest,
                           count_of(model) + ", 0.1 x 0.6 x 0.1 m, a quarter turn, nu = 0.45: elastic energy",
                           "J",
                           measures.elastic,
                           0.98 * kEnergy,
                           1.02 * kEnergy,
                           number(kEnergy) + " J: 7,776 quadratic tets"};
    finding.judged = quadratic;
    verification.add(finding);
    if (!quadratic) continue;
    verification.add(
        {kTest, count_of(model) + ": smallest J", "", measures.min_det_f, 1e-9, 1, "above 0: no tet turns inside out"});
    verification.add({kTest, count_of(model) + ": volume ratio", "", measures.volume_ratio, 0.99, 1.01,
                      "near 1: twisting is shear, and nu is near 0.5"});
  }
}

void verify_block(Verification& verification) {
  const char* const kTest = "Nearly incompressible block";
  constexpr double kForce = 217.6;  // [N]; 384 and 1,296 quadratic tets have 219.4 N and 218.2 N
  for (const ElementOrder elements : kElementOrders) {
    const bool quadratic = elements == ElementOrder::quadratic;
    const Model model = pressed_block(quadratic ? 6 : 12, elements);
    const State state = equilibrium(model);
    const std::vector<reference::Support> supports = reference::support_forces(model, state);
    VerifiedNumber finding{
        kTest,
        count_of(model) + ", cube of 0.1 m between bonded plates, pressed by 15 %, nu = 0.499: force",
        "N",
        supports.empty() ? std::nan("") : supports.front().force.y(),
        0.98 * kForce,
        1.02 * kForce,
        number(kForce) + " N: 3,072 quadratic tets"};
    finding.judged = quadratic;
    verification.add(finding);
    if (quadratic)
      verification.add({kTest, count_of(model) + ": volume ratio", "", reference::measure(model, state).volume_ratio,
                        0.995, 1.005, "near 1: the change of volume is pressure over bulk modulus, 17 MPa"});
  }
}

}  // namespace fascia
