// Reads the top level of a scene file: everything except the bodies.
#include "sim/scene/scene_read.h"

#include <Eigen/Geometry>

#include "base/json/json_document.h"
#include "base/suggest.h"

namespace fascia {
namespace {

constexpr double kLargestAcceleration = 1e6;  // [m/s^2]

}  // namespace

CameraSettings read_camera(const Node& node) {
  CameraSettings camera;
  node.expect_object({"eye", "target", "up", "fov_deg"});
  camera.eye = node.at("eye", "a list of 3 numbers [m] (without a camera the view is framed on the bodies)")
                   .vector(-kFarthestLook, kFarthestLook, "m");
  node.read("target", camera.target, -kFarthestLook, kFarthestLook, "m");
  node.read("up", camera.up, -kFarthestLook, kFarthestLook, "");
  node.read("fov_deg", camera.fov_deg, 1, 170, "degrees");
  const Eigen::Vector3d view = camera.target - camera.eye;
  if (view.isZero(0)) node.fail("eye and target are the same point", "two different points");
  // Below a millionth of a radian the right-hand axis of the picture has no accuracy left in float32.
  if (view.cross(camera.up).norm() <= 1e-6 * view.norm() * camera.up.norm()) {
    node.fail("up has no part across the view from eye to target", "an up vector across the view");
  }
  return camera;
}

SolverSettings read_solver(const Node& node) {
  SolverSettings solver;
  std::vector<std::string> known = {"method", "acceleration"};
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
  return solver;
}

Scene read_scene(const Node& root) {
  root.expect_object(
      {"fascia_scene", "title", "gravity", "bodies", "grabs", "solver", "camera", "display", "duration", "files"});
  root.at("fascia_scene", "1, the version of the format").number(1, 1, "");
  Scene scene;
  if (const auto title = root.find("title")) scene.title = title->text("a text");
  root.read("gravity", scene.gravity, -kLargestAcceleration, kLargestAcceleration, "m/s^2");
  root.read("duration", scene.duration, 0, kLongestTime, "s");
  const Node bodies = root.at("bodies", "a list of at least one body");
  for (const Node& body : bodies.elements("a list of at least one body")) scene.bodies.push_back(read_body(body));
  if (scene.bodies.empty()) bodies.refuse("a list of at least one body");
  if (const auto grabs = root.find("grabs"))
    for (const Node& grab : grabs->elements("a list of grabs")) {
      scene.grabs.push_back(read_grab(grab));
      scene.option_grabs += grab.where("at").starts_with("--grab");
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
  if (const auto camera = root.find("camera")) scene.camera = read_camera(*camera);
  if (const auto display = root.find("display")) scene.display = read_display(*display);
  if (const auto files = root.find("files")) scene.files = read_files(*files);
  return scene;
}

}  // namespace fascia
