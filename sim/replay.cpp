#include "sim/replay.h"

#include "sim/file.h"
#include "sim/scene_json.h"
#include "sim/scene_overrides.h"
#include "sim/scene_read.h"
#include "sim/scene_write.h"

namespace fascia {
namespace {

using Json = nlohmann::ordered_json;
using Eigen::Vector3d;

constexpr double kAnything = 1e30;
constexpr int kMostSteps = 1'000'000'000, kMostVertices = kMostSteps;

Json list_of(const std::vector<Vector3d>& vectors) {
  Json list = Json::array();
  for (const Vector3d& v : vectors) list.push_back(vector_document(v));
  return list;
}

std::vector<Vector3d> read_vectors(const Node& node) {
  std::vector<Vector3d> vectors;
  for (const Node& v : node.elements("a list of vectors, one per vertex")) vectors.push_back(v.vector(-kAnything, kAnything, ""));
  return vectors;
}

Json document_of(const GrabInput& springs) {
  Json list = Json::array();
  for (const GrabSpring& s : springs) {
    list.push_back({s.vertex, s.target.x(), s.target.y(), s.target.z(), s.stiffness});
    if (s.hand != 0) list.back().push_back(s.hand);
  }
  return list;
}

GrabInput read_springs(const Node& node) {
  const std::string expected = "a spring [vertex, x, y, z, stiffness, hand]: the displacement it pulls to [m], N/m, a number if it is not 0";
  GrabInput springs;
  for (const Node& spring : node.elements("a list of springs")) {
    const std::vector<Node> values = spring.elements(expected);
    if (values.size() != 5 && values.size() != 6) spring.refuse(expected);
    const auto coordinate = [&](std::size_t k) { return values[k].number(-kAnything, kAnything, "m"); };
    springs.push_back({static_cast<std::uint32_t>(values[0].integer(0, kMostVertices)), {coordinate(1), coordinate(2), coordinate(3)},
                       values[4].number(0, kAnything, "N/m"),
                       values.size() == 6 ? static_cast<std::uint32_t>(values[5].integer(0, kFirstScriptedHand - 1)) : 0});
  }
  return springs;
}

Json document_of(const Input& input) {
  Json object{{"step", input.step}};
  struct Writer {
    Json& object;
    void operator()(const SolverSettings& settings) { object["solver"] = solver_document(settings); }
    void operator()(const MaterialInput& m) {
      object["material"] = {{"index", m.index}, {"values", material_document(m.material)}};
    }
    void operator()(const GravityInput& g) { object["gravity"] = vector_document(g.gravity); }
    void operator()(const GrabInput& springs) { object["grab"] = document_of(springs); }
  };
  std::visit(Writer{object}, input.change);
  return object;
}

Input read_input(const Node& node, long earliest) {
  const std::string expected = "\"step\" and one of solver, material, gravity, grab";
  node.expect_object({"step", "solver", "material", "gravity", "grab"});
  Input input{node.at("step", expected).integer(static_cast<int>(earliest), kMostSteps), {}};
  if (const auto solver = node.find("solver")) {
    input.change = read_solver(*solver);
  } else if (const auto material = node.find("material")) {
    material->expect_object({"index", "values"});
    input.change = MaterialInput{static_cast<std::size_t>(material->at("index", "that of a material").integer(0, kMostVertices)),
                                 read_material(material->at("values", "a material"))};
  } else if (const auto gravity = node.find("gravity")) {
    input.change = GravityInput{gravity->vector(-kAnything, kAnything, "m/s^2")};
  } else if (const auto grab = node.find("grab")) {
    input.change = read_springs(*grab);
  } else {
    node.refuse(expected);
  }
  return input;
}

}  // namespace

Replay read_replay(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  return read_replay_content(path, read_file(path), overrides);
}

Replay read_replay_content(const std::filesystem::path& path, std::string_view content, const std::vector<std::string>& overrides) {
  DocumentOrigin origin{path.string(), {}};
  nlohmann::json document = parse_json(content, path.string());
  const Node root(document, "", origin);
  root.expect_object({"fascia_replay", "scene", "steps", "start", "inputs"});
  root.at("fascia_replay", "1, the version of the format").number(1, 1, "");
  root.at("scene", "the scene that was open");
  apply_overrides(document["scene"], overrides, origin);
  Replay replay;
  // Overrides name their keys from the scene on, as on the command line, and so do errors in the scene.
  replay.scene = read_scene(Node(document["scene"], "", origin));
  replay.scene.file = path;
  replay.steps = root.at("steps", "how many steps to make").integer(0, kMostSteps);
  if (const auto start = root.find("start")) {
    start->expect_object({"time", "displacement", "velocity"});
    reference::State state;
    state.time = start->at("time", "seconds").number(0, kAnything, "s");
    state.displacement = read_vectors(start->at("displacement", "a vector per vertex [m]"));
    state.velocity = read_vectors(start->at("velocity", "a vector per vertex [m/s]"));
    if (state.displacement.size() != state.velocity.size())
      start->fail(std::to_string(state.displacement.size()) + " displacements, " + std::to_string(state.velocity.size()) + " velocities",
                  "one of each per vertex");
    replay.start = std::move(state);
  }
  if (const auto inputs = root.find("inputs"))
    for (const Node& input : inputs->elements("a list of inputs, in the order of their steps"))
      replay.inputs.push_back(read_input(input, replay.inputs.empty() ? 0 : replay.inputs.back().step));
  return replay;
}

void write_replay(const std::filesystem::path& path, const Replay& replay) {
  write_file(path, replay_to_json(replay, path.parent_path()));
}

std::string replay_to_json(const Replay& replay, const std::filesystem::path& folder) {
  Json document{{"fascia_replay", 1}, {"scene", scene_document(replay.scene, folder)}, {"steps", replay.steps}};
  if (replay.start)
    document["start"] = {{"time", replay.start->time},
                         {"displacement", list_of(replay.start->displacement)},
                         {"velocity", list_of(replay.start->velocity)}};
  document["inputs"] = Json::array();
  for (const Input& input : replay.inputs) document["inputs"].push_back(document_of(input));
  return text_of(document);
}

}  // namespace fascia
