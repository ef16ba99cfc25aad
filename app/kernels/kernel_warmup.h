// Fills the cache of a software renderer with the kernels of a scene, while the program continues. Compiling fused
// kernels (gl/fused_pass.h) takes the CPU seconds, once per driver and kind of scene, and would freeze the program.
// Another process with the same driver compiles them here: `fascia kernels` steps the scene, first free and then
// grabbed, and leaves the kernels in the driver's cache on disk. Those of whole steps come first: the program can use
// them before those of steps in which a part of the tissue rests are compiled.
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
  /// whole_steps: those of whole steps are cached, the others are being compiled. failed: also if the driver keeps no
  /// cache.
  enum class State { running, whole_steps, cached, failed };

  /// Begins at low priority. `program` is the path of fascia, `data_dir` the folder of the shaders.
  KernelWarmup(const std::filesystem::path& program, const Scene& scene, const std::filesystem::path& data_dir);
  ~KernelWarmup();  // ends the other process
  KernelWarmup(const KernelWarmup&) = delete;
  KernelWarmup& operator=(const KernelWarmup&) = delete;

  State look();  // does not wait
  const Scene& scene() const { return scene_; }

 private:
  /// What another process compiles, in this order. Single kernels come first: they are few, small and needed first. A
  /// second run of the fused ones shows whether the driver keeps them.
  enum class Run { single, whole, whole_again, all };

  void begin(Run run);
  void end(State state);
  void follow(double seconds);

  Scene scene_;                 // as it was at the beginning
  std::filesystem::path copy_;  // its file for the other process
  std::vector<std::string> command_;
  std::optional<SpawnedProgram> program_;
  Run run_ = Run::single;
  double compile_seconds_ = 0;  // CPU time of Run::whole
  State state_ = State::running;
};

}  // namespace fascia
