// fascia soak: long runs, and what creeps in them.
#include "app/stress/soak.h"
#include "app/bench/bench.h"
#include "app/commands/command.h"
#include "app/system/paths.h"

namespace fascia {

int command_soak(const BenchOptions& options, const std::vector<std::string>& scenes, long steps) {
  Bench bench(options, "soak");
  try {
    bench.say(describe(bench.graphics));
    std::vector<std::filesystem::path> inputs(scenes.begin(), scenes.end());
    if (inputs.empty())
      for (const char* name : {"cube.json", "inclusion.json", "beam.json"})
        inputs.push_back(default_scene(bench.graphics.data_dir).parent_path() / name);
    return soak_scenes(bench, inputs, steps) > 0 ? exit_failed : exit_done;
  } catch (const Interrupted&) {
    return exit_interrupted;
  }
}

}  // namespace fascia
