#include "sim/replay/replay.h"

#include <algorithm>
#include <array>
#include <bit>

#include "base/byte_hash.h"
#include "base/file.h"
#include "base/json/json_document.h"
#include "sim/scene/scene_overrides.h"
#include "sim/scene/scene_paths.h"
#include "sim/scene/scene_read.h"
#include "sim/scene/scene_write.h"

namespace fascia {
namespace {

constexpr int kMostRows = 10'000'000;  // of contact

using Eigen::Vector3d;

constexpr double kAnything = 1e30;
constexpr int kMostSteps = 1'000'000'000, kMostVertices = kMostSteps;

std::vector<Vector3d> read_vectors(const Node& node) {
  std::vector<Vector3d> vectors;
  for (const Node& v : node.elements("a list of vectors, one per vertex"))
    vectors.push_back(v.vector(-kAnything, kAnything, ""));
  return vectors;
}

GrabInput read_springs(const Node& node) {
  const std::string expected =
      "a spring [vertex, x, y, z, stiffness, grab]: the displacement it pulls to [m], N/m, a number if it is not 0";
  GrabInput springs;
  for (const Node& spring : node.elements("a list of springs")) {
    const std::vector<Node> values = spring.elements(expected);
    if (values.size() != 5 && values.size() != 6) spring.refuse(expected);
    const auto coordinate = [&](std::size_t k) { return values[k].number(-kAnything, kAnything, "m"); };
    springs.push_back(
        {static_cast<std::uint32_t>(values[0].integer(0, kMostVertices)),
         {coordinate(1), coordinate(2), coordinate(3)},
         values[4].number(0, kAnything, "N/m"),
         values.size() == 6 ? static_cast<std::uint32_t>(values[5].integer(0, kFirstScriptedGrab - 1)) : 0});
  }
  return springs;
}

GrabMove read_move(const Node& node) {
  const std::string expected = "a part [count, x, y, z]: of the springs, and how far they were led [m]";
  GrabMove move;
  for (const Node& part : node.elements("a list of parts")) {
    const std::vector<Node> values = part.elements(expected);
    if (values.size() != 4) part.refuse(expected);
    const auto coordinate = [&](std::size_t k) { return values[k].number(-kAnything, kAnything, "m"); };
    move.parts.push_back(
        {static_cast<std::size_t>(values[0].integer(1, kMostVertices)), {coordinate(1), coordinate(2), coordinate(3)}});
  }
  return move;
}

InstrumentInput read_instrument_input(const Node& node) {
  constexpr double kMostDegrees = 1e6;
  node.expect_object({"name", "position", "rotate_deg", "grip"});
  InstrumentInput input;
  input.name = node.at("name", "that of an instrument").text("that of an instrument");
  const auto vector = [&](const char* key, const char* expected, double most) {
    return node.at(key, expected).vector(-most, most, "");
  };
  input.place = {vector("position", "of its origin [x, y, z] [m]", kAnything),
                 vector("rotate_deg", "degrees about x, y and z", kMostDegrees),
                 node.at("grip", "0 to 1").number(0, 1, "")};
  return input;
}

MaterialInput read_material_input(const Node& node) {
  node.expect_object({"index", "values"});
  return {static_cast<std::size_t>(node.at("index", "that of a material").integer(0, kMostVertices)),
          read_material(node.at("values", "a material"))};
}

ResetInput read_reset(const Node& node) {
  const std::string to = node.text("rest or start");
  if (to != "rest" && to != "start") node.refuse("rest or start");
  return {to == "rest"};
}

RestoreInput read_restore(const Node& node) {
  if (!node.boolean()) node.refuse("true");
  return {};
}

struct ChangeKey {
  const char* key;
  Change (*read)(const Node&);
};
const std::vector<ChangeKey>& change_keys() {
  static const std::vector<ChangeKey> keys{
      {"solver", [](const Node& n) -> Change { return read_solver(n); }},
      {"material", [](const Node& n) -> Change { return read_material_input(n); }},
      {"gravity", [](const Node& n) -> Change { return GravityInput{n.vector(-kAnything, kAnything, "m/s^2")}; }},
      {"grab", [](const Node& n) -> Change { return read_springs(n); }},
      {"move", [](const Node& n) -> Change { return read_move(n); }},
      {"instrument", [](const Node& n) -> Change { return read_instrument_input(n); }},
      {"iterations", [](const Node& n) -> Change { return GrantInput{n.integer(1, 10000)}; }},
      {"background", [](const Node& n) -> Change { return BackgroundInput{n.integer(1, kMostSteps)}; }},
      {"reset", [](const Node& n) -> Change { return read_reset(n); }},
      {"sound", [](const Node& n) -> Change { return read_restore(n); }},
      {"camera", [](const Node& n) -> Change { return read_camera(n); }},
      {"display", [](const Node& n) -> Change { return read_display(n); }},
  };
  return keys;
}

Input read_input(const Node& node, long earliest) {
  std::string expected = "\"step\" and one of ";
  std::vector<std::string> known{"step"};
  for (const ChangeKey& change : change_keys()) {
    expected += (known.size() > 1 ? ", " : "") + std::string(change.key);
    known.emplace_back(change.key);
  }
  node.expect_object(known);
  Input input{node.at("step", expected).integer(static_cast<int>(earliest), kMostSteps), {}};
  for (const ChangeKey& change : change_keys())
    if (const auto value = node.find(change.key)) {
      input.change = change.read(*value);
      return input;
    }
  node.refuse(expected);
}

State::Earlier read_earlier(const Node& node, std::size_t vertex_count) {
  node.expect_object({"step", "displacement", "velocity"});
  State::Earlier earlier;
  earlier.step = node.at("step", "seconds").number(0, kAnything, "s");
  earlier.displacement = read_vectors(node.at("displacement", "a vector per vertex [m]"));
  earlier.velocity = read_vectors(node.at("velocity", "a vector per vertex [m/s]"));
  if (earlier.displacement.size() != vertex_count || earlier.velocity.size() != vertex_count)
    node.fail(std::to_string(earlier.displacement.size()) + " displacements, " +
                  std::to_string(earlier.velocity.size()) + " velocities",
              "one of each per vertex, " + std::to_string(vertex_count));
  return earlier;
}

// Rows without a force are left out.
ContactMemory read_contact(const Node& node) {
  const std::string expected = "lists of a row, its normal force and three of friction [N]";
  node.expect_object({"rows", "forces"});
  ContactMemory memory(static_cast<std::size_t>(node.at("rows", "the number of rows").integer(0, kMostRows)));
  for (const Node& force : node.at("forces", expected).elements(expected)) {
    const std::vector<Node> values = force.elements(expected);
    if (values.size() != 5) force.refuse(expected);
    ContactForce& row = memory.at(static_cast<std::size_t>(values[0].integer(0, static_cast<int>(memory.size()) - 1)));
    row.normal = values[1].number(0, kAnything, "N");
    for (int k = 0; k < 3; ++k)
      row.friction[k] = values[static_cast<std::size_t>(2 + k)].number(-kAnything, kAnything, "N");
  }
  return memory;
}

State read_start(const Node& start) {
  start.expect_object({"time", "displacement", "velocity", "earlier", "contact", "instruments"});
  State state;
  state.time = start.at("time", "seconds").number(0, kAnything, "s");
  state.displacement = read_vectors(start.at("displacement", "a vector per vertex [m]"));
  state.velocity = read_vectors(start.at("velocity", "a vector per vertex [m/s]"));
  if (state.displacement.size() != state.velocity.size())
    start.fail(std::to_string(state.displacement.size()) + " displacements, " + std::to_string(state.velocity.size()) +
                   " velocities",
               "one of each per vertex");
  if (const auto earlier = start.find("earlier")) state.earlier = read_earlier(*earlier, state.displacement.size());
  if (const auto contact = start.find("contact")) state.contact = read_contact(*contact);
  if (const auto instruments = start.find("instruments"))
    for (const Node& led : instruments->elements("a list of instruments that left their paths"))
      state.led.push_back(read_instrument_input(led));
  return state;
}

// Recordings hold the names of bodies that their scene did not name, too: those of the meshes' files, which two bodies
// may have had.
void leave_out_given_names(nlohmann::json& scene) {
  if (!scene.is_object() || !scene.contains("bodies") || !scene["bodies"].is_array()) return;
  for (nlohmann::json& body : scene["bodies"]) {
    const auto is_text = [&](const char* key) {
      return body.is_object() && body.contains(key) && body[key].is_string();
    };
    if (is_text("name") && is_text("mesh") &&
        body["name"] == std::filesystem::path(body["mesh"].get<std::string>()).stem().string())
      body.erase("name");
  }
}

// The common part of both formats: scene and start.
Replay read_beginning(nlohmann::json& document, const Node& root, const std::vector<std::string>& overrides,
                      DocumentOrigin& origin) {
  root.at("scene", "the scene that was open");
  leave_out_given_names(document["scene"]);
  apply_overrides(document["scene"], overrides, origin);
  Replay replay;
  // Overrides name their keys relative to the scene, as on the command line, and so do errors in the scene.
  replay.scene = read_scene(Node(document["scene"], "", origin));
  if (const auto start = root.find("start")) replay.start = read_start(*start);
  return replay;
}

long next_step(const Replay& replay) { return replay.inputs.empty() ? 0 : replay.inputs.back().step; }

Replay read_object(nlohmann::json document, const std::string& file, const std::vector<std::string>& overrides) {
  DocumentOrigin origin{file, {}};
  const Node root(document, "", origin);
  root.expect_object({"fascia_replay", "scene", "steps", "start", "inputs"});
  root.at("fascia_replay", "1 or 2, the version of the format").number(1, 1, "");
  Replay replay = read_beginning(document, root, overrides, origin);
  replay.steps = root.at("steps", "how many steps to make").integer(0, kMostSteps);
  if (const auto inputs = root.find("inputs"))
    for (const Node& input : inputs->elements("a list of inputs, in the order of their steps"))
      replay.inputs.push_back(read_input(input, next_step(replay)));
  return replay;
}

Replay read_header(nlohmann::json document, const std::string& file, const std::vector<std::string>& overrides) {
  DocumentOrigin origin{file, {}};
  const Node root(document, "", origin);
  root.expect_object({"fascia_replay", "made_by", "scene", "start", "timed"});
  Replay replay = read_beginning(document, root, overrides, origin);
  if (const auto timed = root.find("timed")) replay.timed = timed->boolean();
  if (const auto made_by = root.find("made_by"))
    for (const auto& [keyword, text] : made_by->members("what made it"))
      replay.made_by.emplace_back(keyword, text.text("a text"));
  return replay;
}

void read_line(const Node& line, Replay& replay) {
  const auto steps = line.find("steps");
  if (!steps) {
    replay.inputs.push_back(read_input(line, next_step(replay)));
    if (replay.inputs.back().step > replay.steps) replay.hash.reset();
    replay.steps = std::max(replay.steps, replay.inputs.back().step);
    return;
  }
  line.expect_object({"steps", "hash"});
  replay.steps = steps->integer(static_cast<int>(replay.steps), kMostSteps);
  replay.hash.reset();
  const auto hash = line.find("hash");
  if (hash) replay.hash = read_hash(*hash);
}

Replay read_lines(nlohmann::json header, const std::string& file, std::string_view lines,
                  const std::vector<std::string>& overrides) {
  Replay replay = read_header(std::move(header), file, overrides);
  for (long number = 2; !lines.empty(); ++number) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    const std::string_view text = lines.substr(0, end);
    const bool ended = end < lines.size();
    lines.remove_prefix(std::min(end + 1, lines.size()));
    if (text.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    const std::string where = file + ":" + std::to_string(number);
    if (!ended && !nlohmann::json::accept(text)) {
      replay.note = where + ": the last line was not written to its end, and is left out";
      break;
    }
    const nlohmann::json document = parse_json(text, where);
    const DocumentOrigin origin{where, {}};
    read_line(Node(document, "", origin), replay);
  }
  return replay;
}

}  // namespace

Replay read_replay(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  Replay replay = read_replay_content(path, read_file(path), overrides);
  find_moved_files(replay.scene);
  return replay;
}

Replay read_replay_content(const std::filesystem::path& path, std::string_view content,
                           const std::vector<std::string>& overrides) {
  const std::size_t first_end = std::min(content.find('\n'), content.size());
  const std::string_view first = content.substr(0, first_end);
  const bool whole = nlohmann::json::accept(first);
  nlohmann::json document = parse_json(whole ? first : content, path.string());
  const bool in_lines =
      whole && document.is_object() && document.contains("fascia_replay") && document["fascia_replay"] == 2;
  if (whole && !in_lines) document = parse_json(content, path.string());  // no content may follow
  Replay replay = in_lines ? read_lines(std::move(document), path.string(),
                                        content.substr(std::min(first_end + 1, content.size())), overrides)
                           : read_object(std::move(document), path.string(), overrides);
  replay.scene.file = path;
  return replay;
}

std::uint64_t state_hash(const State& state) {
  ByteHash hash;
  const auto add = [&](double value) {
    hash.add(std::bit_cast<std::array<std::uint8_t, sizeof value>>(value + 0.0));  // both zeros hash alike
  };
  for (const std::vector<Vector3d>* vectors : {&state.displacement, &state.velocity})
    for (const Vector3d& v : *vectors)
      for (const double coordinate : v) add(coordinate);
  add(state.time);
  return hash.value();
}

}  // namespace fascia
