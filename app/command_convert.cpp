// fascia convert: between mesh formats, keeping vertex order, regions and names where the format can.
#include <iostream>

#include "app/commands.h"
#include "sim/report_text.h"
#include "sim/surface_fill.h"

namespace fascia {

int command_convert(const ConvertOptions& options) {
  const MeshFile file = read_mesh_or_fill(options.in);
  write_mesh(options.out, file.mesh);
  std::cerr << "fascia: " << options.out << ": " << plural(file.mesh.positions.size(), "vertex") << ", "
            << plural(file.mesh.tets.size(), "tet") << ", from " << file.format << '\n';
  for (const std::string& note : file.notes) std::cerr << "fascia: " << note << '\n';
  return exit_done;
}

}  // namespace fascia
