#include "sim/tool/tool_meshes.h"

#include <algorithm>

namespace fascia {

SceneTools with_solids(SceneTools tools, const ReadToolSurface& read) {
  std::vector<MeshShape> known;  // a file is measured once
  for_each_shape(tools, [&](ToolShape& shape, const std::string& key) {
    auto* mesh = std::get_if<MeshShape>(&shape);
    if (!mesh) return;
    const ToolSurfaceFile file = read(mesh->file, key + ".mesh.file");
    const auto same = std::find(known.begin(), known.end(), *mesh);
    mesh->solid = same != known.end()
                      ? same->solid
                      : std::make_shared<const SolidMesh>(solid_of(file.surface, mesh->scale, file.place));
    known.push_back(*mesh);
  });
  return tools;
}

}  // namespace fascia
