// Reads the files of a scene, from the scene itself if it carries them, else from disk. Lists the files that were read,
// so that a recording can carry them.
#pragma once
#include <string>
#include <vector>

#include "base/error.h"
#include "base/progress.h"
#include "sim/scene/scene.h"
#include "sim/surface/shape_file.h"

namespace fascia {

class FileReader {
 public:
  explicit FileReader(const Scene& scene) : scene_(scene) {}

  struct File {
    std::string path;             // as the scene has it
    std::string key;              // the scene key of the file: "bodies[0].mesh"
    std::filesystem::path place;  // the path on disk, or the name of a carried file in errors: scene.json/m.msh
    std::string content;
  };
  /// Throws Error "scene.json: bodies[0].mesh: m.msh: ..." for a file that cannot be read.
  File read(const std::string& path, const std::string& key, const Progress& progress = {});
  /// Includes the files that it names: material libraries, the other file of a TetGen mesh. Throws Error.
  ShapeFile shape(const File& file);
  /// As shape(), of a file that must hold a surface.
  SurfaceMesh surface(const File& file);

  /// What `use` returns. Its errors, which name the file, name the scene and the key before it: "scene.json:
  /// bodies[0].mesh: m.msh:3: ...". Those of a mesh on its own stay as they are.
  template <class F>
  auto blaming(const File& file, F&& use) const {
    try {
      return use();
    } catch (const Error& error) {
      if (file.place == scene_.file) throw;
      throw Error(where() + ": " + file.key + ": " + error.what());
    }
  }

  std::vector<ReadFile> files;     // files that were read, each key and name once
  std::vector<std::string> notes;  // one line each

 private:
  File find_beside(const File& file, const std::string& name);
  void remember(const File& file, const std::string& name = {});
  std::string where() const { return scene_.file.string(); }

  const Scene& scene_;
};

}  // namespace fascia
