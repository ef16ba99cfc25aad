// fascia convert: between mesh formats, keeping vertex order, regions and names where the format can.
#include <iostream>

#include "app/commands.h"
#include "app/output_files.h"
#include "sim/file.h"
#include "sim/report_text.h"
#include "sim/surface_fill.h"
#include "sim/vertex_places.h"

namespace fascia {

int command_convert(const ConvertOptions& options) {
  const auto files_of = [](const std::string& path) {  // TetGen's are two
    const std::string ending = lower_ending(path);
    std::vector<std::filesystem::path> files{path};
    if (ending == ".node" || ending == ".ele") files.push_back(std::filesystem::path(path).replace_extension(ending == ".node" ? ".ele" : ".node"));
    return files;
  };
  for (const std::filesystem::path& out : files_of(options.out)) require_outputs({{"OUT", out.string(), {}}}, files_of(options.in));
  MeshFile file = read_mesh_or_fill(options.in);
  const std::size_t welded = options.weld ? weld(file.mesh) : 0;
  write_mesh(options.out, file.mesh);
  std::cerr << "fascia: " << options.out << ": " << plural(file.mesh.positions.size(), "vertex") << ", "
            << plural(file.mesh.tets.size(), "tet") << ", from " << file.format << '\n';
  if (options.weld) std::cerr << "fascia: --weld: " << plural(welded, "vertex") << " at the place of an earlier one left out\n";
  if (const std::string lost = names_left_out(options.out, file.mesh); !lost.empty()) std::cerr << "fascia: " << lost << '\n';
  for (const std::string& note : file.notes) std::cerr << "fascia: " << note << '\n';
  return exit_done;
}

}  // namespace fascia
