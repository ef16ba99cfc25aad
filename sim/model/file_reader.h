// Reads the files of a scene: what the scene carries, or what lies on disk. Notes what it found, so that a recording
// can carry it.
#pragma once
#include <string>
#include <vector>

#include "base/progress.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/scene/scene.h"
#include "sim/surface/surface_mesh.h"

namespace fascia {

class FileReader {
 public:
  explicit FileReader(const Scene& scene) : scene_(scene) {}

  struct File {
    std::string path;             // as the scene has it
    std::string key;              // that names it: "bodies[0].mesh"
    std::filesystem::path place;  // on disk, or as errors name what the scene carries: scene.json/m.msh
    std::string content;
  };
  /// Throws Error "scene.json: bodies[0].mesh: m.msh: ..." for a file that cannot be read.
  File read(const std::string& path, const std::string& key, const Progress& progress = {});
  /// With its material libraries. Throws Error.
  SurfaceMesh surface(const File& file);
  /// With the other half of a TetGen mesh. Throws Error.
  MeshFile tets(const File& file);

  std::vector<ReadFile> files;     // that were read, each key and name once
  std::vector<std::string> notes;  // one line each

 private:
  File find_beside(const File& file, const std::string& name);
  void remember(const File& file, const std::string& name = {});
  std::string where() const { return scene_.file.string(); }

  const Scene& scene_;
};

}  // namespace fascia
