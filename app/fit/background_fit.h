// `fascia fit` in a child process, on a copy of a scene with its meshes: the window goes on, a crash or a scene that
// needs too much memory does not end it, and a fit can be ended at any time.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/system/spawned_program.h"
#include "sim/fit/estimate.h"
#include "sim/scene/scene.h"

namespace fascia {

struct FitTask {
  std::filesystem::path measured;
  std::vector<std::string> keys;  // free values
  std::uint32_t probe = 0;        // vertex of the columns probe_*
  bool equilibria = false;        // instead of motion
};

class BackgroundFit {
 public:
  /// Begins at the values of `scene`, which carries its files. `program`: that of fascia. Throws Error.
  BackgroundFit(const std::filesystem::path& program, const Scene& scene, const FitTask& task);
  ~BackgroundFit();  // ends it

  bool ended();                   // does not wait
  std::string last_line() const;  // of what it says: how far it is, and at its end why it failed
  /// Once it has ended. None: it failed.
  std::optional<std::vector<Estimate>> found();

 private:
  struct Folder {
    std::filesystem::path path;
    Folder();
    ~Folder();
  };
  const Folder folder_;
  std::optional<SpawnedProgram> program_;
};

}  // namespace fascia
