// Measures the force of a bar while it is stretched, and restores a saved state: a tensile test with grabs.
#include <cstdio>

#include "fascia/fascia.h"

int main() try {
  constexpr double kLength = 0.1, kSide = 0.02, kModulus = 5e4, kArea = kSide * kSide;
  fascia::Body bar;
  bar.name = "bar";
  bar.mesh = fascia::make_box(10, 2, 2, {kLength, kSide, kSide});
  bar.material = {.young_modulus = kModulus, .poisson_ratio = 0, .model = "st_venant_kirchhoff"};
  std::vector<std::uint32_t> end;
  for (std::uint32_t v = 0; v < bar.mesh.vertex_count(); ++v) {
    if (bar.mesh.positions[3 * v] == 0) bar.fixed.push_back(v);
    if (bar.mesh.positions[3 * v] == kLength) end.push_back(v);
  }
  fascia::Scene scene;
  scene.gravity = {0, 0, 0};
  scene.bodies.push_back(bar);
  fascia::Simulation simulation(scene);
  const fascia::State at_rest = simulation.save();

  const fascia::Grab clamp = simulation.grab(end, 1e5);  // far stiffer than the bar, 200 N/m
  const fascia::Vec3 from = simulation.target(clamp);
  std::printf("# stretch, force of the clamp [N], of the support [N], of St. Venant and Kirchhoff's law [N]\n");
  for (const double percent : {5.0, 10.0, 20.0}) {
    simulation.restore(at_rest);
    simulation.move(clamp, {from[0] + percent / 100 * kLength, from[1], from[2]});
    if (!simulation.solve_static().converged) throw fascia::Error("measure_force: no equilibrium");
    double x = 0;
    const std::vector<double> positions = simulation.positions();
    for (const std::uint32_t v : end) x += positions[3 * v] / static_cast<double>(end.size());
    const double stretch = x / kLength, law = kModulus * kArea * stretch * (stretch * stretch - 1) / 2;
    std::printf("stretch_%.0f %.6f %.6f %.6f %.6f\n", percent, stretch, simulation.force(clamp)[0],
                simulation.supports()[0].force[0], law);
  }

  // The same bar hangs at the clamp under its weight.
  simulation.set_gravity({-9.81, 0, 0});
  simulation.move(clamp, from);
  simulation.solve_static();
  double weight = 0;
  for (const double mass : simulation.masses()) weight += 9.81 * mass;
  std::printf("weight %.6f %.6f\n", weight, simulation.force(clamp)[0] + simulation.supports()[0].force[0]);
} catch (const fascia::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
