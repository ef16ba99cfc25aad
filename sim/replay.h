// What a user did to a scene, step by step, in a file that repeats it: the scene, the state it started from and the inputs. On the same
// device the same steps give the same bits. JSON, format "fascia_replay": 1, strict as scene files are (sim/scene.h).
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/grab_spring.h"
#include "sim/reference/newton.h"
#include "sim/scene.h"

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

struct Input {
  long step;  // takes effect before this step; the first one is 0
  std::variant<SolverSettings, MaterialInput, GravityInput, GrabInput> change;
  bool operator==(const Input&) const = default;
};

struct Replay {
  Scene scene;
  std::optional<reference::State> start;  // none: at rest, as the scene says
  std::vector<Input> inputs;              // in the order of their steps
  long steps = 0;                         // to make
};

/// `overrides` are --set texts for the scene. Throws Error for anything that is not a replay.
Replay read_replay(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});
void write_replay(const std::filesystem::path& path, const Replay& replay);

/// As read_replay of a file with this content, and what write_replay puts into a file in `folder`.
Replay read_replay_content(const std::filesystem::path& path, std::string_view content, const std::vector<std::string>& overrides = {});
std::string replay_to_json(const Replay& replay, const std::filesystem::path& folder);

}  // namespace fascia
