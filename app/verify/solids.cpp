#include "app/verify/solids.h"

#include <limits>

#include "sim/mesh/mesh_generate.h"
#include "sim/reference/newton.h"

namespace fascia {

using Eigen::Vector3d;

Material material_of(MaterialModel law, double young_modulus, double poisson_ratio) {
  Material material;
  material.model = law;
  material.young_modulus = young_modulus;
  material.poisson_ratio = poisson_ratio;
  return material;
}

Model solid(const TetMesh& mesh, const Material& material, ElementOrder elements, const std::vector<Selection>& fixed,
            const std::vector<PrescribedMotion>& motions) {
  Scene scene;
  scene.file = "verify";
  scene.gravity.setZero();
  Body body;
  body.name = "solid";
  body.material = material;
  body.elements = elements;
  body.fixed = fixed;
  body.prescribed = motions;
  scene.bodies.push_back(body);
  return build_bodies(scene, {mesh});
}

Model hanging_beam(int cells, double poisson_ratio, ElementOrder elements) {
  const int across = std::max(1, cells / 4);
  Model model = solid(make_box(cells, across, across, {1, 0.25, 0.25}),
                      material_of(MaterialModel::st_venant_kirchhoff, 1e6, poisson_ratio), elements,
                      {BoxSelection{{-1e-6, -1, -1}, {1e-6, 1, 1}}});
  model.gravity = {0, -9.81, 0};
  return model;
}

void prescribe_surface(Model& model, const Vector3d& size, const std::function<Vector3d(const Vector3d&)>& u) {
  Motion motion;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v) {
    const Vector3d& x = model.rest_positions[v];
    if ((x.array() > 1e-9 * size.array()).all() && (x.array() < (1 - 1e-9) * size.array()).all()) continue;
    motion.vertices.push_back(v);
    motion.targets.push_back(x + u(x));
  }
  model.motions = {std::move(motion)};
}

State equilibrium(const Model& model, const std::vector<GrabSpring>& springs) {
  State state = initial_state(model);
  reference::NewtonSolver solver(model, {});
  solver.set_springs(springs);
  if (!solver.solve_static(state).converged)
    for (Vector3d& u : state.displacement) u.setConstant(std::numeric_limits<double>::quiet_NaN());
  return state;
}

Vector3d displacement_at(const Model& model, const State& state, const Vector3d& place) {
  std::size_t next = 0;
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
    if ((model.rest_positions[v] - place).squaredNorm() < (model.rest_positions[next] - place).squaredNorm()) next = v;
  return state.displacement[next];
}

std::string count_of(const Model& model) {
  return std::to_string(model.tets.size()) + (model.has_quadratic() ? " quadratic tets" : " linear tets");
}

}  // namespace fascia
