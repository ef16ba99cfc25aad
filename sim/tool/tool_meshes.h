// The meshes of a scene's obstacles and instruments.
#pragma once
#include <functional>

#include "sim/scene/tools/scene_tools.h"
#include "sim/tool/solid_mesh.h"

namespace fascia {

/// The surface of a file of the scene, and its place for errors. `key`: "obstacles[0].shape.mesh.file".
struct ToolSurfaceFile {
  SurfaceMesh surface;
  std::string place;
};
using ReadToolSurface = std::function<ToolSurfaceFile(const std::string& file, const std::string& key)>;

/// `tools` with MeshShape::solid. Throws Error for a surface that is not closed, and what `read` throws.
SceneTools with_solids(SceneTools tools, const ReadToolSurface& read);

}  // namespace fascia
