// The inputs of a user to a scene, step by step, in a file that repeats them: the scene, the initial state and the
// inputs. On the same device the same steps give the same bits. The file consists of JSON lines, so that a recording
// can be read at any time, even if its writer ends unexpectedly: first {"fascia_replay": 2, "scene": ..., "start":
// ...}, then one input per line, and at intervals {"steps": N}, the number of steps so far. "fascia_replay": 1, one
// object with all of it, is still read. The reader is as strict as that of scene files (sim/scene/scene.h).
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/byte_hash.h"
#include "base/provenance.h"
#include "sim/grab/grab_track.h"
#include "sim/model/grab_spring.h"
#include "sim/model/state.h"
#include "sim/scene/scene.h"

namespace fascia {

struct MaterialInput {
  std::size_t index;  // into Model::materials
  Material material;
  bool operator==(const MaterialInput&) const = default;
};
struct GravityInput {
  Eigen::Vector3d gravity;  // [m/s^2]
  bool operator==(const GravityInput&) const = default;
};
using GrabInput = std::vector<GrabSpring>;  // all springs from this step on; empty: no grab
using InstrumentInput = LedTool;            // at this place at the end of this step, and led from then on
struct GrantInput {
  int iterations;  // that fit into solver.frame_budget from this step on
  bool operator==(const GrantInput&) const = default;
};
struct BackgroundInput {
  int results;  // number of background results (GpuSolver::hold_background) that were ready and taken
  bool operator==(const BackgroundInput&) const = default;
};
struct ResetInput {     // values are not changed
  bool to_rest = true;  // to the scene's rest state; else to the start of the replay
  bool operator==(const ResetInput&) const = default;
};
struct RestoreInput {  // the state diverged: back to the last valid one, at rest
  bool operator==(const RestoreInput&) const = default;
};

using Change = std::variant<SolverSettings, MaterialInput, GravityInput, GrabInput, GrabMove, InstrumentInput,
                            GrantInput, BackgroundInput, ResetInput, RestoreInput, CameraSettings, DisplaySettings>;

struct Input {
  long step;  // takes effect before this step, counted from 0; camera and display are visible from then on
  Change change;
  bool operator==(const Input&) const = default;
};

struct Replay {
  Scene scene;
  std::optional<State> start;  // none: the scene's rest state
  std::vector<Input> inputs;   // in the order of their steps
  long steps = 0;              // to run
  /// Background results are taken at the recorded BackgroundInputs; otherwise at once after every input.
  bool timed = false;
  std::optional<std::uint64_t> hash = {};  // state_hash after the last step
  Provenance made_by = {};
  std::string note = {};  // of the reader, about skipped content; empty: none
};

/// `overrides` are --set texts for the scene. Throws Error if the file is not a replay. An incomplete last line is
/// skipped, with a note.
Replay read_replay(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});
void write_replay(const std::filesystem::path& path, const Replay& replay);

/// As read_replay of a file with this content, and the content that write_replay writes to a file in `folder`.
Replay read_replay_content(const std::filesystem::path& path, std::string_view content,
                           const std::vector<std::string>& overrides = {});
std::string replay_to_json(const Replay& replay, const std::filesystem::path& folder);

/// The lines of such a file, each with its line break. The first one has paths relative to `folder`
/// (sim/scene/scene_paths.h).
std::string replay_header(const Replay& replay, const std::filesystem::path& folder);
std::string replay_line(const Input& input);
std::string replay_steps_line(long steps, std::optional<std::uint64_t> hash = std::nullopt);

/// Hash of displacements, velocities and time, exact to the bit (FNV-1a, 64 bits).
std::uint64_t state_hash(const State& state);

}  // namespace fascia
