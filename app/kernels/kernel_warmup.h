// Fills the cache of a software renderer with the kernels of a scene, while the program continues. Compiling fused
// kernels (gl/fused_pass.h) takes the CPU seconds, once per driver and kind of scene, and would freeze the program.
// Another process with the same driver compiles them here: `fascia kernels` steps the scene, first free and then
// grabbed, and leaves the kernels in the driver's cache on disk.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/system/spawned_program.h"
#include "sim/scene/scene.h"

namespace fascia {

class KernelWarmup {
 public:
  enum class State { running, cached, failed };  // failed: also if the driver keeps no cache

  /// Begins at low priority. `program` is the path of fascia, `data_dir` the folder of the shaders.
  KernelWarmup(const std::filesystem::path& program, const Scene& scene, const std::filesystem::path& data_dir);
  ~KernelWarmup();  // ends the other process
  KernelWarmup(const KernelWarmup&) = delete;
  KernelWarmup& operator=(const KernelWarmup&) = delete;

  State look();  // does not wait
  const Scene& scene() const { return scene_; }

 private:
  void begin();
  void begin_again();
  void remove_file();

  Scene scene_;                 // as it was at the beginning
  std::filesystem::path copy_;  // its file for the other process
  std::vector<std::string> command_;
  std::optional<SpawnedProgram> program_;
  bool single_ = true;        // the single kernels of a grab come first: they are needed first
  double first_seconds_ = 0;  // CPU time of the first run; 0 while it runs
  State state_ = State::running;
};

}  // namespace fascia
