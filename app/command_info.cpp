// fascia info: the mesh doctor's report, for a mesh or for every body of a scene.
#include <iomanip>
#include <iostream>
#include <numeric>

#include "app/commands.h"
#include "sim/mesh_doctor.h"
#include "sim/model.h"

namespace fascia {

int command_info(const InfoOptions& options) {
  const Scene scene = open_scene(options.input, options.sets);
  for (const Body& body : scene.bodies) {
    const std::filesystem::path path = scene.resolve(body.mesh);
    const MeshFile file = read_mesh(path);
    const MeshRepair repaired = repair(file.mesh);
    std::cout << path.string() << '\n';
    print_report(std::cout, file, repaired, examine(file.mesh, repaired));
  }
  const Model model = build_model(scene);
  const std::vector<double> masses = lumped_masses(model);
  std::cout << "\nscene\n";
  std::cout << "  mass         " << std::accumulate(masses.begin(), masses.end(), 0.0) << " kg\n";
  std::cout << "  fixed        " << model.fixed.size() << " vertices\n";
  std::size_t prescribed = 0;
  for (const Motion& motion : model.motions) prescribed += motion.vertices.size();
  std::cout << "  prescribed   " << prescribed << " vertices\n";
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    const Material& m = model.materials[i];
    std::cout << "  material     " << model.material_names[i] << ": E " << m.young_modulus << " Pa, nu " << m.poisson_ratio
              << ", density " << m.density << " kg/m^3, damping " << m.damping << " s\n";
  }
  for (const std::string& note : model.notes) std::cout << "  note         " << note << '\n';
  return exit_done;
}

}  // namespace fascia
