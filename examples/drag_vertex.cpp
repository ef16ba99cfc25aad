// Drags the upper corner of a cube that stands on its lower side, keeps it there, and releases it.
#include <cmath>
#include <cstdio>

#include "fascia/fascia.h"

namespace {

void print(const char* name, const fascia::Vec3& v, const char* unit) {
  std::printf("%s %.6f %.6f %.6f %s\n", name, v[0], v[1], v[2], unit);
}

}  // namespace

int main() try {
  constexpr int kCells = 4;
  constexpr double kEdge = 0.1;  // [m]
  fascia::Scene scene;
  fascia::Body cube;
  cube.mesh = fascia::make_box(kCells, kCells, kCells, {kEdge, kEdge, kEdge});
  cube.material = {.young_modulus = 2e4, .poisson_ratio = 0.4, .density = 1000, .damping = 0.05};
  for (std::uint32_t v = 0; v < cube.mesh.vertex_count(); ++v)
    if (cube.mesh.positions[3 * v + 1] == 0) cube.fixed.push_back(v);
  const auto corner = static_cast<std::uint32_t>(cube.mesh.vertex_count() - 1);  // the largest x, y and z
  scene.bodies.push_back(cube);
  fascia::Simulation simulation(scene);

  const fascia::Grab grab = simulation.grab_vertex(corner, 500);  // N/m
  const fascia::Vec3 from = simulation.target(grab);
  constexpr int kSteps = 30;
  for (int step = 1; step <= kSteps; ++step) {
    simulation.move(grab, {from[0] + 0.03 * step / kSteps, from[1] + 0.01 * step / kSteps, from[2]});
    simulation.step();
  }
  const fascia::StaticReport report = simulation.solve_static();  // instead of steps until the cube is at rest
  std::printf("residual %.2g\n", report.relative_residual);
  print("target", simulation.target(grab), "m");
  print("force", simulation.force(grab), "N");

  // In equilibrium the forces of grab and supports equal the weight.
  double weight = 0;
  for (const double mass : simulation.masses()) weight += mass * 9.81;
  fascia::Vec3 sum = simulation.force(grab);
  for (const fascia::Support& support : simulation.supports())
    for (int k = 0; k < 3; ++k) sum[static_cast<std::size_t>(k)] += support.force[static_cast<std::size_t>(k)];
  std::printf("weight %.6f N\n", weight);
  print("carried", sum, "N");

  simulation.release(grab);
  simulation.step(120);
  const std::vector<double> x = simulation.positions();
  std::printf("speed %.6f m/s\n", simulation.diagnostics().max_speed);
  std::printf("left %.6f m\n", std::hypot(x[3 * corner] - kEdge, x[3 * corner + 2] - kEdge));
} catch (const fascia::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
