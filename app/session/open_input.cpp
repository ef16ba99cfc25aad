#include "app/session/open_input.h"

#include <algorithm>
#include <cmath>

#include "app/cli/command_line.h"
#include "app/cli/usage_error.h"
#include "app/session/advice.h"
#include "app/session/progress_lines.h"
#include "app/system/paths.h"
#include "base/error.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "sim/bare_mesh/settled_model.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/replay/replay_time.h"
#include "sim/scene/scene_paths.h"

namespace fascia {
namespace {

Opened open_replay(const std::filesystem::path& path, const std::vector<std::string>& sets, const Progress& progress) {
  Replay replay = read_replay(path, sets);
  Scene scene = replay.scene;
  Model model = settled_model(scene, progress);
  Opened opened{std::move(scene), std::move(replay), std::move(model)};
  const Replay& read = *opened.replay;
  if (!read.note.empty()) opened.model.notes.push_back(read.note);
  const auto mesh = std::find_if(read.made_by.begin(), read.made_by.end(),
                                 [](const auto& entry) { return entry.first == "Mesh hash"; });
  if (mesh == read.made_by.end() || mesh->second == hash_text(mesh_hash(opened.model.file_mesh)) ||
      !read.scene.files.empty())
    return opened;
  // Without a record of its files, this is the only check that a replay's file that was found by name elsewhere is the
  // same mesh.
  if (!read.scene.notes.empty())
    throw Error(read.scene.notes.front(), "the mesh differs from the recorded one",
                "expected the recorded mesh beside the replay");
  opened.model.notes.push_back(path.string() + ": recorded with a mesh that its file no longer holds");
  return opened;
}

}  // namespace

void require_steps_or_static(const CommonOptions& options) {
  if (options.static_equilibrium && (options.steps || options.time))
    throw UsageError(options.steps ? "--steps" : "--time", "means nothing with --static", "leave out one of them");
}

std::vector<std::filesystem::path> input_files(const Scene& scene) {
  std::vector<std::filesystem::path> files{scene.file};
  for_each_path(scene, [&](const std::string& path, const std::string&) {
    if (!scene.carries(path)) files.push_back(scene.resolve(path));
  });
  return files;
}

Scene open_scene_or_input(const std::filesystem::path& path, const std::vector<std::string>& sets) {
  if (lower_ending(path) == ".gltf") read_mesh(path);  // JSON that is no scene: the error names the program that helps
  if (path != kStandardInput) return open_scene(path, sets);
  constexpr const char* kName = "standard input";  // without a folder: paths are relative to the working folder
  if (read_standard_input().empty()) throw Error(kName, "is empty", "expected a scene (JSON)");
  return read_scene_content(kName, read_standard_input(), sets);
}

Opened open_file(const std::filesystem::path& path, const std::vector<std::string>& sets, const Progress& progress) {
  if (lower_ending(path) == ".fascia") return open_replay(path, sets, progress);
  Scene scene = open_scene_or_input(path, sets);
  Model model = settled_model(scene, progress);
  return {std::move(scene), std::nullopt, std::move(model)};
}

Opened open_input(const CommonOptions& options, const std::vector<std::string>& sets) {
  if (!options.data_dir.empty()) find_data_dir(options.data_dir);  // sets the folder of "assets:"
  std::vector<std::string> overrides = sets;
  for (const std::string& set : mesh_frame_sets(options.unit, options.up)) overrides.push_back(set);
  for (const std::string& grab : options.grabs) overrides.push_back("--grab " + grab);
  for (const std::string& instrument : options.instruments) overrides.push_back("--instrument " + instrument);
  if (!options.replay.empty() && !options.input.empty())
    throw UsageError("--replay", "has a scene of its own", "leave out " + options.input);
  return blaming_options([&] {
    const EndAtOnce opening;
    const std::filesystem::path path = !options.replay.empty() ? std::filesystem::path(options.replay)
                                       : options.input.empty() ? default_scene(find_data_dir(options.data_dir))
                                                               : input_or_shipped(options.input, options.data_dir);
    const Progress progress = options.quiet ? Progress() : opening_progress(path.string());
    Opened opened =
        !options.replay.empty() ? open_replay(path, overrides, progress) : open_file(path, overrides, progress);
    if (options.replay.empty() && !options.input.empty())
      if (const std::string note = shipped_note(options.input, path); !note.empty()) opened.model.notes.push_back(note);
    if (const auto unit = unit_hint(opened.scene, opened.model)) opened.model.notes.push_back(unit->hint.help);
    const auto names = [&](const std::string& key) {
      return std::any_of(sets.begin(), sets.end(), [&](const std::string& set) { return set.starts_with(key); });
    };
    if (names("solver.method=") != names("solver.acceleration="))  // the other one may have changed with it
      opened.model.notes.push_back(std::string("solver: ") + name_of(opened.scene.solver.method) + " + " +
                                   name_of(opened.scene.solver.acceleration));
    return opened;
  });
}

long steps_to_run(const CommonOptions& options, const Simulation& simulation) {
  if (options.steps) return *options.steps;
  const double time_step = simulation.scene.solver.time_step;
  if (options.time && simulation.replay()) return ReplayTime(*simulation.replay()).steps(*options.time);
  if (options.time) {
    constexpr double kMostSteps = 1e15;
    if (*options.time > kMostSteps * time_step)
      throw UsageError("--time", "is more than " + std::to_string(static_cast<long>(kMostSteps)) + " steps",
                       "expected less");
    const long steps = std::lround(*options.time / time_step);
    if (steps == 0 && *options.time > 0)
      throw UsageError("--time " + std::to_string(*options.time), "is less than half a step",
                       "expected at least " + std::to_string(time_step) + " s, or 0");
    return steps;
  }
  return simulation.replay() ? simulation.replay()->steps : std::lround(simulation.scene.duration / time_step);
}

}  // namespace fascia
