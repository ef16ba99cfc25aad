// A soft cube in free fall: the shortest program.
#include <cstdio>

#include "fascia/fascia.h"

int main() try {
  fascia::Scene scene;
  scene.bodies.push_back(
      {.name = "cube", .mesh = fascia::make_box(3, 3, 3, {0.1, 0.1, 0.1}), .material = fascia::tissue("liver")});

  fascia::Simulation simulation(scene);
  std::printf("fascia %s on %s, data in %s\n", fascia::version(), simulation.context().renderer().c_str(),
              fascia::data_dir().c_str());
  std::printf("%zu vertices, %zu tets\n", simulation.vertex_count(), simulation.tet_count());

  simulation.step(60);  // of 1/60 s

  const std::vector<double> x = simulation.positions();
  double drop = 0;
  for (std::size_t v = 0; v < simulation.vertex_count(); ++v)
    drop += (simulation.rest_positions()[3 * v + 1] - x[3 * v + 1]) / static_cast<double>(simulation.vertex_count());
  const fascia::Diagnostics now = simulation.diagnostics();
  std::printf("time %.6f s\n", now.time);
  std::printf("drop %.6f m\n", drop);
  std::printf("speed %.6f m/s\n", now.max_speed);
  std::printf("volume_ratio %.6f\n", now.volume_ratio);
} catch (const fascia::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
