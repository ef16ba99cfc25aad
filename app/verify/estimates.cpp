// How good the estimate of the mesh's error is: effectivity, the estimate over the error against a finer solution.
#include <algorithm>
#include <cmath>
#include <map>

#include "app/verify/solids.h"
#include "app/verify/verification.h"
#include "base/text.h"
#include "sim/accuracy/mesh_error.h"
#include "sim/accuracy/relative_distance.h"
#include "sim/mesh/mesh_generate.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

const Selection kLeftEnd = BoxSelection{{-1e-6, -1, -1}, {1e-6, 1, 1}},
                kRightEnd = BoxSelection{{1 - 1e-6, -1, -1}, {1 + 1e-6, 1, 1}};

/// A bar of 1 x 0.25 x 0.25 m in a state that loads bring it to, at any resolution.
struct Loading {
  const char* name;
  Model (*model)(int cells, double nu, ElementOrder elements);
  int fine;  // resolution of the truth, by quadratic tets
};

Model bar(int cells, double nu, ElementOrder elements, const std::vector<Selection>& fixed,
          const std::vector<PrescribedMotion>& motions, const Vector3d& gravity) {
  Model model = solid(make_box(cells, cells / 4, cells / 4, {1, 0.25, 0.25}),
                      material_of(MaterialModel::st_venant_kirchhoff, 1e6, nu), elements, fixed, motions);
  model.gravity = gravity;
  return model;
}

const Loading kBent{"bent by its weight", hanging_beam, 24};
const Loading kClamped{"clamped at both ends",
                       [](int cells, double nu, ElementOrder elements) {
                         return bar(cells, nu, elements, {kLeftEnd, kRightEnd}, {}, {0, -40, 0});
                       },
                       24};
const Loading kTwisted{"twisted by 60 degrees",
                       [](int cells, double nu, ElementOrder elements) {
                         PrescribedMotion twist;
                         twist.select = kRightEnd;
                         twist.angle_deg = 60;
                         twist.center = {0, 0.125, 0.125};
                         return bar(cells, nu, elements, {kLeftEnd}, {twist}, {0, 0, 0});
                       },
                       24};
const Loading kDrawn{"drawn out by its weight",
                     [](int cells, double nu, ElementOrder elements) {
                       return bar(cells, nu, elements, {kLeftEnd}, {}, {60, 0, 0});
                     },
                     24};

/// Displacements at the vertices that all resolutions share, each times the root of its share of the volume.
std::vector<Vector3d> displacements_of(const Model& model, const State& state) {
  constexpr int kCells = 8, kAcross = 2;
  std::vector<Vector3d> result;
  for (int i = 0; i <= kCells; ++i)
    for (int j = 0; j <= kAcross; ++j)
      for (int k = 0; k <= kAcross; ++k) {
        const auto at_end = [](int n, int last) { return n == 0 || n == last ? 0.5 : 1.0; };
        const double share = at_end(i, kCells) * at_end(j, kAcross) * at_end(k, kAcross);
        result.push_back(std::sqrt(share) * displacement_at(model, state, Vector3d(i, j, k) / kCells));
      }
  return result;
}

}  // namespace

void verify_estimates(Verification& verification) {
  const char* const kTest = "Estimated error of the mesh";
  struct Row {
    const Loading* loading;
    int cells;
    double nu;
    ElementOrder elements;
  };
  constexpr ElementOrder kLinear = ElementOrder::linear, kQuadratic = ElementOrder::quadratic;
  const Row rows[] = {{&kBent, 8, 0.3, kLinear},     {&kBent, 16, 0.3, kLinear},      {&kBent, 24, 0.3, kLinear},
                      {&kBent, 16, 0.45, kLinear},   {&kBent, 24, 0.49, kLinear},     {&kBent, 8, 0.3, kQuadratic},
                      {&kClamped, 16, 0.3, kLinear}, {&kClamped, 8, 0.3, kQuadratic}, {&kTwisted, 16, 0.3, kLinear},
                      {&kDrawn, 16, 0.3, kLinear}};
  std::vector<double> effectivities;
  std::map<std::pair<const Loading*, double>, std::vector<Vector3d>> truths;
  for (const Row& row : rows) {
    const auto [truth, added] = truths.try_emplace({row.loading, row.nu});
    if (added) {
      const Model fine = row.loading->model(row.loading->fine, row.nu, kQuadratic);
      truth->second = displacements_of(fine, equilibrium(fine));
    }
    const Model model = row.loading->model(row.cells, row.nu, row.elements);
    const State state = equilibrium(model);
    const double error = relative_distance(displacements_of(model, state), truth->second);
    const double effectivity = estimate_mesh_error(model, state).displacement / error;
    effectivities.push_back(effectivity);
    verification.add({kTest,
                      "bar " + std::string(row.loading->name) + ", " + count_of(model) + ", nu = " + number(row.nu) +
                          ": estimate over error",
                      "", effectivity, 0.7, 1.5,
                      "error " + number(100 * error) + " % of the displacements, against 5,184 quadratic tets"});
  }
  std::sort(effectivities.begin(), effectivities.end());
  verification.add({kTest, "ten meshes: median of estimate over error", "",
                    0.5 * (effectivities[effectivities.size() / 2 - 1] + effectivities[effectivities.size() / 2]), 0.7,
                    1.5, "1"});
}

}  // namespace fascia
