#include "app/stress/case_maker.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "sim/grab/build_model.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/model/model.h"

namespace fascia {

using Eigen::Vector3d;

TetMesh StressCases::beam(double length) const {
  const int along = static_cast<int>(std::lround((quick ? 4 : 8) * length / kBarLength)), across = quick ? 2 : 4;
  return make_box(along, across, across, {length, kBarWidth, kBarWidth});
}

Scene StressCases::scene(const std::string& mesh_name, const TetMesh& mesh, bool clamped) {
  const std::uint64_t hash = mesh_hash(mesh);
  if (const auto [known, added] = meshes.emplace(mesh_name, hash); !added && known->second != hash)
    throw std::logic_error("stress suite: two meshes have the name " + mesh_name);
  write_mesh(folder / "meshes" / (mesh_name + ".msh"), mesh);
  Scene made;
  made.file = folder / "stress.json";
  made.title = mesh_name;
  made.gravity.setZero();
  Body body;
  body.name = "body";
  body.mesh = "meshes/" + mesh_name + ".msh";
  body.material.young_modulus = 1e6;
  body.material.model = model;
  body.elements = elements;
  if (clamped) body.fixed.push_back(BoxSelection{{-kNearFace, -1, -1}, {kNearFace, 1, 1}});
  made.bodies.push_back(body);
  made.solver = solver();
  return made;
}

std::optional<State> StressCases::start(const Scene& scene,
                                        const std::function<Vector3d(const Vector3d&)>& place) const {
  const Model built = build_model(scene);
  State state = initial_state(built);
  const std::vector<char> held = built.held();
  for (std::size_t v = 0; v < held.size(); ++v)
    if (!held[v]) state.displacement[v] = float32_of(place(built.rest_positions[v]) - built.rest_positions[v]);
  return state;
}

std::optional<State> StressCases::bent(const Scene& scene) const {
  return start(scene, [](const Vector3d& x) -> Vector3d {
    return x + Vector3d(-0.2 * x.x() * x.x() / kBarLength, 0.3 * x.x() * x.x() / kBarLength, 0);
  });
}

StressCase& StressCases::add(const std::string& group, const std::string& name, Scene scene, std::optional<State> state,
                             long steps) {
  StressCase& made = cases.emplace_back();
  made.group = group;
  made.name = name;
  made.replay = {std::move(scene), std::move(state), {}, steps};
  return made;
}

SolverSettings StressCases::solver() const {
  SolverSettings settings;
  settings.method = pair.method;
  settings.acceleration = pair.acceleration;
  settings.integrator = integrator;
  return settings;
}

GrabInput grip_end(const Model& built, const Vector3d& offset) {
  GrabInput springs;
  const double stiffness = 3 * 1e6 * 0.08 * 0.5 * kBarSize;
  for (std::uint32_t v = 0; v < built.rest_positions.size(); ++v)
    if (built.rest_positions[v].x() > 0.99 * kBarLength) springs.push_back({v, offset, 0});
  for (GrabSpring& spring : springs) spring.stiffness = stiffness / static_cast<double>(springs.size());
  return springs;
}

std::string in_short(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace fascia
