// Quadratic tets against CalculiX's C3D10 where Poisson's ratio is not zero. Both are quadratic tets with four points,
// but C3D10 takes the change of volume at the points, and fascia its mean over the tet. With K = lambda the energy of
// the same displacements so differs by K/2 times the variance of tr E over each tet, which falls with the square of the
// edge length:
//
//   - fascia's minimum lies below that of CalculiX on every mesh;
//   - energies and displacements differ by C h^2 + higher orders: half the edges have a quarter of the difference;
//   - (4 d(h/2) - d(h)) / 3 leaves the higher orders.
//
// Covers: quadratic_elasticity
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/reference/newton.h"
#include "tests/sim/reference/calculix_cube.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;
using test::CalculixCube;

/// Own less CalculiX's.
struct Difference {
  double energy;                       // relative
  std::vector<Vector3d> displacement;  // [m]
};

Difference difference_to(const CalculixCube& cube) {
  const Model model = test::displaced_cube(cube.cells, cube.nu);
  State state = initial_state(model);
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
    state.displacement[v] = test::on_cube_surface(model.rest_positions[v]);  // else tets at the surface begin inverted
  const NewtonReport report = NewtonSolver(model, {}).solve_static(state);
  CAPTURE(report.iterations, report.relative_residual);
  REQUIRE(report.converged);
  Difference result{measure(model, state).elastic / cube.energy - 1, {}};
  for (std::size_t place = 0; place < test::kCalculixPlaces.size(); ++place)
    for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
      if ((model.rest_positions[v] - test::kCalculixPlaces[place]).norm() < 1e-9)
        result.displacement.push_back(state.displacement[v] - cube.displacement[place]);
  REQUIRE(result.displacement.size() == test::kCalculixPlaces.size());
  return result;
}

double rms(const std::vector<Vector3d>& vectors) {
  double sum = 0;
  for (const Vector3d& v : vectors) sum += v.squaredNorm();
  return std::sqrt(sum / static_cast<double>(vectors.size()));
}

}  // namespace

TEST_CASE("quadratic tets approach the solution of CalculiX's C3D10 with the square of the edge length",
          "[quadratic]") {
  const std::size_t row = GENERATE(0, 2, 4);
  const CalculixCube &coarse = test::kCalculixCubes[row], &fine = test::kCalculixCubes[row + 1];
  REQUIRE(coarse.nu == fine.nu);
  REQUIRE(2 * coarse.cells == fine.cells);
  const Difference before = difference_to(coarse), after = difference_to(fine);
  std::vector<Vector3d> extrapolated, whole(fine.displacement.begin(), fine.displacement.end());
  for (std::size_t place = 0; place < whole.size(); ++place)
    extrapolated.push_back((4 * after.displacement[place] - before.displacement[place]) / 3);
  const double energy_order = std::log2(before.energy / after.energy),
               extrapolated_energy = (4 * after.energy - before.energy) / 3,
               order = std::log2(rms(before.displacement) / rms(after.displacement)),
               extrapolated_displacement = rms(extrapolated) / rms(whole);
  CAPTURE(fine.nu, before.energy, after.energy, energy_order, extrapolated_energy,
          rms(before.displacement) / rms(whole), rms(after.displacement) / rms(whole), order,
          extrapolated_displacement);
  CHECK(before.energy < 0);
  CHECK(after.energy < 0);
  CHECK(energy_order > 1.7);
  CHECK(energy_order < 2.3);
  CHECK(order > 1.7);
  // Coarse meshes show less of the order the more the pressure varies, which at 0.49 is five times as stiff as at 0.45.
  const double bound = fine.nu < 0.46 ? 1e-3 : 2.5e-3;
  CHECK(std::abs(extrapolated_energy) < bound);
  CHECK(extrapolated_displacement < bound);
}

}  // namespace fascia::reference
