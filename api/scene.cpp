#include "api/scene.h"

#include <algorithm>

#include "api/material.h"
#include "api/mesh.h"
#include "api/settings.h"
#include "api/values.h"
#include "sim/grab/build_model.h"
#include "sim/model/region_materials.h"

namespace fascia::api {
namespace {

void require_vertices(const std::vector<std::uint32_t>& vertices, std::size_t count, const std::string& where) {
  for (const std::uint32_t v : vertices)
    if (v >= count)
      throw Error(where, "names vertex " + std::to_string(v), "expected an index below " + std::to_string(count));
}

fascia::Body checked(const Body& body, const std::string& where) {
  fascia::Body own;
  own.name = body.name;
  const auto* const elements = std::find_if(std::begin(kElementOrders), std::end(kElementOrders),
                                            [&](ElementOrder order) { return body.elements == name_of(order); });
  if (elements == std::end(kElementOrders))
    throw Error(where + ".elements", "is \"" + body.elements + "\"", "expected linear or quadratic");
  own.elements = *elements;
  own.material = checked(body.material, where + ".material");
  for (const auto& [region, material] : body.region_materials) {
    const fascia::Material m = checked(material, where + ".region_materials[" + std::to_string(region) + "]");
    own.region_materials.emplace_back(std::to_string(region), override_with(m));
  }
  require_vertices(body.fixed, body.mesh.vertex_count(), where + ".fixed");
  if (!body.fixed.empty()) own.fixed.emplace_back(VertexSelection{body.fixed});
  for (std::size_t m = 0; m < body.motions.size(); ++m) {
    const Motion& motion = body.motions[m];
    const std::string place = where + ".motions[" + std::to_string(m) + "]";
    require_vertices(motion.vertices, body.mesh.vertex_count(), place);
    if (motion.vertices.empty()) throw Error(place, "moves nothing", "expected at least one vertex");
    if (!(motion.start >= 0 && motion.duration >= 0 && std::isfinite(motion.start + motion.duration)))
      throw Error(place, "start or duration below 0", "expected seconds");
    PrescribedMotion led;
    led.select = VertexSelection{motion.vertices};
    led.translate = vector_of(motion.translate, place + ".translate");
    led.start = motion.start;
    led.duration = motion.duration;
    own.prescribed.push_back(std::move(led));
  }
  return own;
}

}  // namespace

BuiltScene build(const Scene& scene) {
  BuiltScene built;
  fascia::Scene& own = built.scene;
  own.file = "scene";  // the name in errors
  own.title = scene.title;
  own.gravity = vector_of(scene.gravity, "scene.gravity");
  own.solver = checked(scene.settings);
  if (scene.bodies.empty()) throw Error("scene", "has no bodies", "expected at least one");
  std::vector<TetMesh> meshes;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::string where = "bodies[" + std::to_string(b) + "]";
    meshes.push_back(checked(scene.bodies[b].mesh, where + ".mesh"));
    own.bodies.push_back(checked(scene.bodies[b], where));
  }
  built.model = build_model(own, std::move(meshes));
  require_carried(own.solver.method, built.model.materials, "settings.method");
  const std::vector<char> held = built.model.held();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::vector<double>& given = scene.bodies[b].initial_velocity;
    if (given.empty()) continue;
    const BodyPart& part = built.model.bodies[b];
    const std::vector<Eigen::Vector3d> velocity =
        vectors_of(given, part.vertex_count, "bodies[" + std::to_string(b) + "].initial_velocity");
    for (std::uint32_t v = 0; v < part.vertex_count; ++v)
      if (!held[part.vertex_begin + v]) built.model.initial_velocity[part.vertex_begin + v] = velocity[v];
  }
  return built;
}

}  // namespace fascia::api
