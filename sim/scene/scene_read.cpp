// Reads the top level of a scene file: everything except the bodies.
#include "sim/scene/scene_read.h"

#include <Eigen/Geometry>

#include "base/json/json_document.h"
#include "base/suggest.h"
#include "sim/scene/tools/read_tools.h"

namespace fascia {
namespace {

constexpr double kLargestAcceleration = 1e6;             // [m/s^2]
constexpr double kNarrowestLens = 1, kWidestLens = 170;  // [degrees]

CameraSettings read_place(const Node& node) {
  CameraSettings camera;
  camera.eye = node.at("eye", "a list of 3 numbers [m] (without a camera the view is framed on the bodies)")
                   .vector(-kFarthestLook, kFarthestLook, "m");
  node.read("target", camera.target, -kFarthestLook, kFarthestLook, "m");
  node.read("up", camera.up, -kFarthestLook, kFarthestLook, "");
  node.read("fov_deg", camera.fov_deg, kNarrowestLens, kWidestLens, "degrees");
  const Eigen::Vector3d view = camera.target - camera.eye;
  if (view.isZero(0)) node.fail("eye and target are the same point", "two different points");
  // Below a millionth of a radian the right-hand axis of the picture has no accuracy left in float32.
  if (view.cross(camera.up).norm() <= 1e-6 * view.norm() * camera.up.norm()) {
    node.fail("up has no part across the view from eye to target", "an up vector across the view");
  }
  return camera;
}

CameraKey read_camera_key(const Node& node) {
  constexpr double kMostTurns = 1000, kSteepest = 89, kFarthestZoom = 1e3;
  node.expect_object({"time", "eye", "orbit_deg", "elevation_deg", "zoom", "target", "fov_deg"});
  CameraKey key;
  key.time = node.at("time", "seconds").number(0, kLongestTime, "s");
  const auto vector = [&](const char* name, std::optional<Eigen::Vector3d>& field) {
    if (const auto given = node.find(name)) field = given->vector(-kFarthestLook, kFarthestLook, "m");
  };
  const auto number = [&](const char* name, std::optional<double>& field, double min, double max, const char* unit) {
    const auto given = node.find(name);
    if (given) field = given->number(min, max, unit);
    return given.has_value();
  };
  vector("eye", key.eye);
  vector("target", key.target);
  const bool turns = number("orbit_deg", key.orbit_deg, -360 * kMostTurns, 360 * kMostTurns, "degrees");
  const bool rises = number("elevation_deg", key.elevation_deg, -kSteepest, kSteepest, "degrees");
  const bool zooms = number("zoom", key.zoom, 1 / kFarthestZoom, kFarthestZoom, "");
  number("fov_deg", key.fov_deg, kNarrowestLens, kWidestLens, "degrees");
  if (key.eye && (turns || rises || zooms))
    node.fail("has eye and orbit_deg, elevation_deg or zoom", "eye alone, or the others");
  if (key.eye && key.target && *key.eye == *key.target)
    node.fail("eye and target are the same point", "two different points");
  return key;
}

CameraMotion read_camera_motion(const Node& node) {
  CameraMotion motion;
  if (const auto keys = node.find("keys")) {
    const std::string expected = "a list of keys, times ascending, such as {\"time\": 4, \"orbit_deg\": 360}";
    for (const Node& element : keys->elements(expected)) {
      motion.keys.push_back(read_camera_key(element));
      if (const std::size_t n = motion.keys.size(); n > 1 && !(motion.keys[n - 2].time < motion.keys[n - 1].time))
        element.fail("time is " + excerpt(motion.keys.back().time), "a later time than that of the key before");
    }
    if (motion.keys.empty()) keys->refuse(expected);
  }
  if (const auto smooth = node.find("smooth")) {
    motion.smooth = smooth->boolean();
    if (motion.keys.empty()) smooth->fail("has no keys to go through", "camera.keys beside it");
  }
  return motion;
}

// A camera that only moves begins where the bodies are framed.
void read_scene_camera(const Node& node, Scene& scene) {
  node.expect_object({"eye", "target", "up", "fov_deg", "keys", "smooth"});
  scene.camera_motion = read_camera_motion(node);
  const bool has_place = node.find("eye") || node.find("target") || node.find("up") || node.find("fov_deg");
  if (has_place || scene.camera_motion.keys.empty()) scene.camera = read_place(node);
}

}  // namespace

CameraSettings read_camera(const Node& node) {
  node.expect_object({"eye", "target", "up", "fov_deg"});
  return read_place(node);
}

namespace {

Integrator read_integrator(const Node& node) {
  std::vector<std::string> names;
  std::string expected;
  for (const IntegratorInfo& info : integrators()) {
    expected += (names.empty() ? "" : ", ") + std::string(info.name);
    names.emplace_back(info.name);
  }
  const std::string name = node.text(expected);
  const std::optional<Integrator> integrator = find_integrator(name);
  if (!integrator) node.fail("is " + excerpt(name) + perhaps(name, names), expected);
  return *integrator;
}

}  // namespace

SolverSettings read_solver(const Node& node) {
  SolverSettings solver;
  std::vector<std::string> known = {"method", "acceleration", "integrator"};
  visit_settings(solver, [&](auto&, const char* name, auto&&...) { known.push_back(name); });
  node.expect_object(known);
  visit_settings(solver, [&](auto& field, const char* name, const char* unit, auto min, auto max, auto&&...) {
    if constexpr (std::is_same_v<std::decay_t<decltype(field)>, int>) {
      node.read(name, field, min, max);
    } else {
      node.read(name, field, min, max, unit);
    }
  });

  const std::string expected = "a method and acceleration that exist: " + list_of_choices();
  const auto method_node = node.find("method"), acceleration_node = node.find("acceleration");
  std::optional<std::string> method, acceleration;
  if (method_node) method = method_node->text(expected);
  if (acceleration_node) acceleration = acceleration_node->text(expected);
  std::vector<std::string> methods, accelerations;
  for (const SolverChoice& pair : solver_choices()) {
    methods.push_back(name_of(pair.method));
    accelerations.push_back(name_of(pair.acceleration));
  }
  if (method && !find_choice(method, {})) {
    method_node->fail("is " + excerpt(*method) + perhaps(*method, methods), expected);
  }
  if (acceleration && !find_choice({}, acceleration)) {
    acceleration_node->fail("is " + excerpt(*acceleration) + perhaps(*acceleration, accelerations), expected);
  }
  const auto pair = find_choice(method, acceleration);
  if (!pair) acceleration_node->fail(excerpt(*acceleration) + " does not go with " + excerpt(*method), expected);
  solver.method = pair->method;
  solver.acceleration = pair->acceleration;
  if (const auto integrator = node.find("integrator")) solver.integrator = read_integrator(*integrator);
  return solver;
}

namespace {

std::string body_key(std::size_t b) { return "bodies[" + std::to_string(b) + "]"; }

// Before those of tools: the name of an --instrument is then the one that is refused. That of the ground has no key.
void claim_names(const Node& root, const std::vector<Node>& elements, const std::vector<Body>& bodies,
                 SceneNames& names) {
  if (const auto ground = root.find("ground")) names.claim(*ground, "ground", "the ground");
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (!bodies[b].name.empty()) names.claim(elements[b].at("name", ""), bodies[b].name, body_key(b));
}

void name_the_rest(std::vector<Body>& bodies, SceneNames& names) {
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies[b].name.empty())
      bodies[b].name = names.give(std::filesystem::path(bodies[b].mesh).stem().string(), body_key(b));
}

}  // namespace

Scene read_scene(const Node& root) {
  root.expect_object({"fascia_scene", "title", "gravity", "bodies", "grabs", "contact", "ground", "obstacles",
                      "instruments", "solver", "camera", "display", "duration", "files"});
  root.at("fascia_scene", "1, the version of the format").number(1, 1, "");
  Scene scene;
  if (const auto title = root.find("title")) scene.title = title->text("a text");
  root.read("gravity", scene.gravity, -kLargestAcceleration, kLargestAcceleration, "m/s^2");
  root.read("duration", scene.duration, 0, kLongestTime, "s");
  const Node bodies = root.at("bodies", "a list of at least one body");
  const std::vector<Node> elements = bodies.elements("a list of at least one body");
  for (const Node& body : elements) scene.bodies.push_back(read_body(body));
  if (scene.bodies.empty()) bodies.refuse("a list of at least one body");
  if (const auto grabs = root.find("grabs"))
    for (const Node& grab : grabs->elements("a list of grabs")) {
      scene.grabs.push_back(read_grab(grab));
      scene.option_grabs += grab.where("at").starts_with("--grab");
    }
  SceneNames names;
  claim_names(root, elements, scene.bodies, names);
  scene.tools = read_tools(root, names);
  name_the_rest(scene.bodies, names);
  if (const auto contact = root.find("contact")) {
    std::vector<std::string> body_names;
    for (const Body& body : scene.bodies) body_names.push_back(body.name);
    require_own_columns(*contact, body_names, scene.tools);
  }
  const auto solver = root.find("solver");
  if (solver) {
    scene.solver = read_solver(*solver);
  } else {
    scene.solver.method = solver_choices().front().method;
    scene.solver.acceleration = solver_choices().front().acceleration;
  }
  const std::string method = solver ? solver->where("method") : root.where("solver.method");
  for (const Body& body : scene.bodies) {
    std::vector<Material> materials{body.material};
    for (const auto& [region, values] : body.region_materials)
      if (values.model) materials.emplace_back().model = *values.model;
    require_carried(scene.solver.method, materials, method);
  }
  if (const auto camera = root.find("camera")) read_scene_camera(*camera, scene);
  if (const auto display = root.find("display")) scene.display = read_display(*display);
  if (const auto files = root.find("files")) scene.files = read_files(*files);
  return scene;
}

}  // namespace fascia
