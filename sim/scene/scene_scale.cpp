#include "sim/scene/scene_scale.h"

#include "base/error.h"
#include "sim/scene/tools/scale_tools.h"

namespace fascia {
void scale_lengths(Scene& scene, double factor) {
  const auto refuse = [&](std::size_t body, const std::string& key, const std::string& path) {
    throw Error(scene.file.string() + ": bodies[" + std::to_string(body) + "]." + key, "has its lengths in " + path,
                "scale that file and transform.scale by hand");
  };
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    for (const PrescribedMotion& motion : body.prescribed)
      if (!motion.targets.empty()) refuse(b, "prescribed", motion.targets);
    if (const auto* file = std::get_if<std::string>(&body.initial_velocity)) refuse(b, "initial_velocity", *file);
  }
  for (Body& body : scene.bodies) {
    body.transform.scale *= factor;
    body.transform.translate *= factor;
    for (PrescribedMotion& motion : body.prescribed) {
      motion.translate *= factor;
      motion.center *= factor;
    }
    std::get<Eigen::Vector3d>(body.initial_velocity) *= factor;
  }
  for (ScriptedGrab& grab : scene.grabs) {
    if (auto* at = std::get_if<Eigen::Vector3d>(&grab.where)) *at *= factor;
    if (grab.radius) *grab.radius *= factor;
    grab.translate *= factor;
    if (grab.push) *grab.push *= factor;
    for (ScriptedGrab::Key& key : grab.path) key.displacement *= factor;
  }
  scale_lengths(scene.tools, factor);
  if (scene.display.section) scene.display.section->offset *= factor;
  if (scene.camera) {
    scene.camera->eye *= factor;
    scene.camera->target *= factor;
  }
  for (CameraKey& key : scene.camera_motion.keys) {
    if (key.eye) *key.eye *= factor;
    if (key.target) *key.target *= factor;
  }
}

}  // namespace fascia
