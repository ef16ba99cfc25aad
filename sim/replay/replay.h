// What a user did to a scene, step by step, in a file that repeats it: the scene, the state it started from and the
// inputs. On the same device the same steps give the same bits. A file of JSON lines, so that one that is being
// recorded can be read at any moment, whatever becomes of its writer: first {"fascia_replay": 2, "scene": ..., "start":
// ...}, then an input a line, now and then {"steps": N}, the steps that were made by then. "fascia_replay": 1, one
// object with all of it, is still read. Strict as scene files are (sim/scene/scene.h).
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
using GrabInput = std::vector<GrabSpring>;  // all springs from now on; empty: let go
struct GrantInput {
  int iterations;  // that fit into solver.frame_budget from now on
  bool operator==(const GrantInput&) const = default;
};
struct BackgroundInput {
  int results;  // of what is computed beside the frames (GpuSolver::hold_background) that were ready and taken
  bool operator==(const BackgroundInput&) const = default;
};
struct ResetInput {     // values stay as they are
  bool to_rest = true;  // as the scene says; else to where the replay starts
  bool operator==(const ResetInput&) const = default;
};
struct RestoreInput {  // the state came apart: back to the last sound one, at rest
  bool operator==(const RestoreInput&) const = default;
};

using Change = std::variant<SolverSettings, MaterialInput, GravityInput, GrabInput, GrabMove, GrantInput,
                            BackgroundInput, ResetInput, RestoreInput, CameraSettings, DisplaySettings>;

struct Input {
  long step;  // takes effect before this step; the first one is 0. Camera and display: seen from then on
  Change change;
  bool operator==(const Input&) const = default;
};

struct Replay {
  Scene scene;
  std::optional<State> start;  // none: at rest, as the scene says
  std::vector<Input> inputs;   // in the order of their steps
  long steps = 0;              // to make
  /// What is computed beside the frames is taken where a BackgroundInput says so; else at once after every input.
  bool timed = false;
  std::optional<std::uint64_t> hash = {};  // state_hash after the last step
  Provenance made_by = {};
  std::string note = {};  // of the reader: what it left out; empty: nothing
};

/// `overrides` are --set texts for the scene. Throws Error for anything that is not a replay. A last line that was not
/// written to its end is left out, with a note.
Replay read_replay(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});
void write_replay(const std::filesystem::path& path, const Replay& replay);

/// As read_replay of a file with this content, and what write_replay puts into a file in `folder`.
Replay read_replay_content(const std::filesystem::path& path, std::string_view content,
                           const std::vector<std::string>& overrides = {});
std::string replay_to_json(const Replay& replay, const std::filesystem::path& folder);

/// The lines of such a file, each with its end. The first one has paths as seen from `folder`
/// (sim/scene/scene_paths.h).
std::string replay_header(const Replay& replay, const std::filesystem::path& folder);
std::string replay_line(const Input& input);
std::string replay_steps_line(long steps, std::optional<std::uint64_t> hash = std::nullopt);

/// Of displacements, velocities and time, to the bit (FNV-1a, 64 bits).
std::uint64_t state_hash(const State& state);

}  // namespace fascia
