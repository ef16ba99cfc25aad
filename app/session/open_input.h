// Opens the input of a command, and determines the number of steps.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/options.h"
#include "sim/grab/build_model.h"
#include "sim/simulation/simulation.h"

namespace fascia {

/// The opened input: --replay's scene, else the scene or mesh that is named, else the default one.
struct Opened {
  Scene scene;
  std::optional<Replay> replay;
  Model model;  // build_model(scene)
};
/// As open_scene(); "-" is a scene on standard input, with paths relative to the working folder.
Scene open_scene_or_input(const std::filesystem::path& path, const std::vector<std::string>& sets = {});
/// Opens a replay if the extension is .fascia, else a scene or mesh.
Opened open_file(const std::filesystem::path& path, const std::vector<std::string>& sets = {},
                 const Progress& progress = {});
/// Prints progress on stderr at intervals if it takes long, unless quiet. A signal ends the program at once during this
/// time.
Opened open_input(const CommonOptions& options, const std::vector<std::string>& sets);
/// The number of steps of a command: --steps, else --time, else those of the replay, else the scene's duration.
long steps_to_run(const CommonOptions& options, const Simulation& simulation);

/// Throws UsageError for --static together with a number of steps.
void require_steps_or_static(const CommonOptions& options);

/// The scene's file, and those on disk that it names.
std::vector<std::filesystem::path> input_files(const Scene& scene);

}  // namespace fascia
