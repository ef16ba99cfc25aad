// Cook's membrane (Cook 1974) as a solid: a tapered panel, clamped at its left edge, with a shear load at its right
// one. Sensitive to bending, to distorted elements and, at nu near 0.5, to locking.
#include <cmath>
#include <map>

#include "app/verify/solids.h"
#include "app/verify/verification.h"
#include "base/text.h"
#include "sim/mesh/mesh_generate.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 0.048, kLeft = 0.044, kRight = 0.016, kThickness = 0.01;  // [m]
constexpr double kLoad = 2;                                                          // [N]

Model membrane(int cells, double nu, ElementOrder elements) {
  TetMesh mesh = make_box(cells, cells, std::max(1, cells / 4), {1, 1, 1});
  deform(mesh, [](const Vector3d& x) -> Vector3d {
    return {kLength * x.x(), kLeft * x.x() + x.y() * (kLeft + (kRight - kLeft) * x.x()), kThickness * x.z()};
  });
  return solid(mesh, material_of(MaterialModel::neo_hookean, 1e6, nu), elements,
               {BoxSelection{{-1, -1, -1}, {1e-9, 1, 1}}});
}

/// The load spread over the right edge as a uniform shear stress. Dead loads: springs so soft and long that their force
/// does not change.
std::vector<GrabSpring> load_on(const Model& model) {
  constexpr double kStiffness = 1e-6;     // [N/m]
  std::map<std::uint32_t, double> areas;  // of the vertices at the edge [m^2], times six
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      std::vector<std::size_t> face;
      for (std::size_t a = 0; a < 4; ++a)
        if (a != left_out && model.rest_positions[model.tets[t][a]].x() > kLength - 1e-9) face.push_back(a);
      if (face.size() < 3) continue;
      const auto corner = [&](std::size_t k) { return model.rest_positions[model.tets[t][face[k]]]; };
      const double area = 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
      if (!model.is_quadratic(t)) {
        for (const std::size_t a : face) areas[model.tets[t][a]] += area / 3;
        continue;
      }
      for (std::size_t m = 0; m < 6; ++m)  // corners of a quadratic face carry nothing
        if (kMidEdgeCorners[m][0] != left_out && kMidEdgeCorners[m][1] != left_out)
          areas[model.mid_edges[t][m]] += area / 3;
    }
  std::vector<GrabSpring> springs;
  for (const auto& [vertex, area] : areas) {
    const double force = kLoad * area / (kRight * kThickness);
    springs.push_back({vertex, {0, force / kStiffness, 0}, kStiffness});
  }
  return springs;
}

}  // namespace

void verify_cook(Verification& verification) {
  const char* const kTest = "Cook's membrane";
  struct Truth {
    double nu, tip;  // [mm]
  };
  // Aitken's extrapolation of 96, 768 and 6,144 quadratic tets: 4.396, 4.446, 4.467 mm and 4.381, 4.456, 4.486 mm. The
  // corner at the support is singular, so that the error halves from one to the next.
  const Truth truths[] = {{0.3, 4.482}, {0.499, 4.506}};
  Chart chart{kTest, {"vertices", true, {}}, {"displacement of the upper right corner [mm]", false, {}}, {}, {}};
  for (std::size_t k = 0; k < std::size(truths); ++k) {
    const auto [nu, tip] = truths[k];
    for (const ElementOrder elements : kElementOrders) {
      const bool quadratic = elements == ElementOrder::quadratic;
      Series series = series_of(elements, nu, static_cast<int>(k));
      std::vector<int> resolutions{4, 8};
      if (!quadratic || verification.full) resolutions.push_back(16);
      for (const int cells : resolutions) {
        const Model model = membrane(cells, nu, elements);
        const double found =
            1000 * displacement_at(model, equilibrium(model, load_on(model)), {kLength, 0.06, 0.5 * kThickness}).y();
        series.points.emplace_back(static_cast<double>(model.rest_positions.size()), found);
        if (cells != 8) continue;
        VerifiedNumber finding{
            kTest,      count_of(model) + ", nu = " + number(nu) + ": upper right corner",      "mm", found, 0.98 * tip,
            1.02 * tip, number(tip) + " mm: extrapolated from 96, 768 and 6,144 quadratic tets"};
        finding.judged = quadratic;
        verification.add(finding);
      }
      chart.series.push_back(std::move(series));
    }
  }
  verification.draw(kTest, "cook", chart);
}

}  // namespace fascia
