// A mesh from the program's own arrays: a column of two materials that hangs from its upper end and stretches under its
// weight.
#include <algorithm>
#include <cstdio>

#include "fascia/fascia.h"

namespace {

constexpr int kCells = 20;
constexpr double kWidth = 0.02, kHeight = 0.2;  // [m]

/// Four vertices per level, from the top down. Every cell is cut into six tets around its diagonal.
fascia::Mesh column() {
  fascia::Mesh mesh;
  for (int level = 0; level <= kCells; ++level)
    for (int corner = 0; corner < 4; ++corner)
      for (const double c : {(corner & 1) * kWidth, -level * kHeight / kCells, (corner >> 1) * kWidth})
        mesh.positions.push_back(c);
  constexpr unsigned kTets[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
  for (unsigned cell = 0; cell < kCells; ++cell)
    for (const auto& tet : kTets) {
      for (const unsigned vertex : tet) mesh.tets.push_back(4 * cell + vertex);
      mesh.regions.push_back(cell < kCells / 2 ? 1 : 2);
    }
  return mesh;
}

/// Mean displacement of the lower end's four vertices, downward [mm].
double stretch(const fascia::Simulation& simulation) {
  const std::vector<double> x = simulation.positions();
  double y = 0;
  for (int corner = 0; corner < 4; ++corner) y += x[static_cast<std::size_t>(3 * (4 * kCells + corner) + 1)] / 4;
  return 1000 * (-kHeight - y);
}

}  // namespace

int main() try {
  fascia::Body body;
  body.name = "column";
  body.mesh = column();
  body.material = {.young_modulus = 1e6, .poisson_ratio = 0};
  body.region_materials[2] = {.young_modulus = 5e5, .poisson_ratio = 0};
  body.fixed = {0, 1, 2, 3};
  fascia::Scene scene;
  scene.bodies.push_back(body);
  fascia::Simulation simulation(scene);
  for (std::size_t m = 0; m < simulation.material_count(); ++m)
    std::printf("%s: %g Pa\n", simulation.material_name(m).c_str(), simulation.material(m).young_modulus);

  const fascia::StaticReport report = simulation.solve_static();
  const std::vector<double> stress = simulation.von_mises();
  std::printf("converged %d\n", report.converged);
  std::printf("stretch %.6f mm\n", stretch(simulation));
  // For small strains: the weight below every cross-section over its modulus, integrated.
  std::printf("closed_form %.6f mm\n", 1000 * 1000 * 9.81 * kHeight * kHeight * (3.0 / 8 / 1e6 + 1.0 / 8 / 5e5));
  std::printf("largest_stress %.3f Pa\n", *std::max_element(stress.begin(), stress.end()));

  // Makes the lower part twice as stiff during the simulation.
  fascia::Material stiffer = simulation.material(1);
  stiffer.young_modulus = 1e6;
  simulation.set_material(simulation.material_name(1) == "column: 2" ? 1 : 0, stiffer);
  simulation.solve_static();
  std::printf("stiffer %.6f mm\n", stretch(simulation));
} catch (const fascia::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
