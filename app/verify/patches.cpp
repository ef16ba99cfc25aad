// Patch tests (Irons, Razzaque 1972): irregular tets under an affine displacement of their surface must take it exactly
// inside, with the uniform stress of the law.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "app/verify/solids.h"
#include "app/verify/verification.h"
#include "base/text.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/reference/elasticity.h"
#include "sim/reference/newton.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const Vector3d kSize(0.3, 0.2, 0.2);

TetMesh irregular_box() {
  TetMesh mesh = make_box(3, 2, 2, kSize);
  std::mt19937 random(31);
  std::uniform_real_distribution<double> uniform(-0.02, 0.02);
  deform(mesh, [&](const Vector3d& x) -> Vector3d {
    const bool inside = (x.array() > 1e-9).all() && (x.array() < kSize.array() - 1e-9).all();
    const Vector3d shift(uniform(random), uniform(random), uniform(random));
    return inside ? Vector3d(x + shift) : x;
  });
  return mesh;
}

}  // namespace

void verify_patches(Verification& verification) {
  const Matrix3d f = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix() *
                     Vector3d(1.1, 0.95, 0.9).asDiagonal() *
                     Eigen::AngleAxisd(0.4, Vector3d(-1, 1, 3).normalized()).toRotationMatrix();
  for (const ElementOrder elements : kElementOrders)
    for (const double nu : {0.3, 0.49}) {
      const Material material = material_of(MaterialModel::st_venant_kirchhoff, 1e5, nu);
      Model model = solid(irregular_box(), material, elements, {});
      prescribe_surface(model, kSize, [&](const Vector3d& x) -> Vector3d { return f * x - x; });
      const State state = equilibrium(model);
      double largest = 0, size = 0, stress_error = 0;
      for (std::size_t v = 0; v < state.displacement.size(); ++v) {
        const Vector3d exact = f * model.rest_positions[v] - model.rest_positions[v];
        largest = std::fmax(largest, (state.displacement[v] - exact).norm());
        size = std::max(size, exact.norm());
        if (!state.displacement[v].allFinite()) largest = std::numeric_limits<double>::infinity();
      }
      const double stress = reference::von_mises(f, material);
      for (const double found : reference::export_fields(model, state).von_mises)
        stress_error = std::fmax(stress_error, std::abs(found / stress - 1));
      const std::string which = count_of(model) + ", nu = " + number(nu);
      const std::string truth = "0: the affine displacement solves the problem exactly";
      verification.add({"Patch test", which + ": largest error of displacement, relative", "", largest / size, 0, 1e-9,
                        truth + "; bound: the solver's tolerance, 1e-10"});
      verification.add({"Patch test", which + ": largest error of von Mises stress, relative", "", stress_error, 0,
                        1e-6, truth + "; bound: the same, over the strains and times lambda / mu"});
    }
}

}  // namespace fascia
