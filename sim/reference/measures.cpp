// Measures a state of the reference solver: energies, momenta, reactions, strains and stresses.
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "sim/reference/elasticity.h"
#include "sim/reference/newton.h"

namespace fascia::reference {
namespace {

using Eigen::Vector3d;

Corners gather(const std::vector<Vector3d>& vectors, const Tet& tet) {
  return {vectors[tet[0]], vectors[tet[1]], vectors[tet[2]], vectors[tet[3]]};
}

}  // namespace

Measures measure(const Model& model, const State& state) {
  Measures result;
  double strain2 = 0, volume = 0, growth = 0;
  const std::vector<double> mass = lumped_masses(model);
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < mass.size(); ++v) {
    const Vector3d position = model.rest_positions[v] + state.displacement[v];
    const Vector3d momentum = mass[v] * state.velocity[v];
    result.kinetic += 0.5 * momentum.dot(state.velocity[v]);
    result.gravitational -= mass[v] * model.gravity.dot(state.displacement[v]);
    result.momentum += momentum;
    result.angular_momentum += position.cross(momentum);
    if (held[v]) result.fixed_reaction -= mass[v] * model.gravity;
  }
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const LinearTet rest(gather(model.rest_positions, model.tets[t]));
    const Corners u = gather(state.displacement, model.tets[t]);
    const Derivatives d =
        elastic(rest, u, model.materials[model.tet_material[t]], 0, Eigen::Matrix3d::Zero(), false, false);
    result.elastic += d.energy;
    for (int a = 0; a < 4; ++a)
      if (held[model.tets[t][a]]) result.fixed_reaction += d.gradient.segment<3>(3 * a);
    strain2 += rest.volume * green_strain_matrix(rest, u).squaredNorm();
    volume += rest.volume;
    const double det_f = rest.deformation_gradient(u).determinant();
    result.min_det_f = t == 0 ? det_f : std::min(result.min_det_f, det_f);
    result.max_det_f = t == 0 ? det_f : std::max(result.max_det_f, det_f);
    growth += rest.volume * (det_f - 1);
    result.inverted += det_f <= 0;
  }
  if (volume > 0) {
    result.rms_strain = std::sqrt(strain2 / volume);
    result.volume_ratio = 1 + growth / volume;
  }
  return result;
}

std::vector<Support> support_forces(const Model& model, const State& state) {
  constexpr std::size_t kFree = static_cast<std::size_t>(-1);
  std::vector<Support> supports;
  std::vector<std::size_t> support_of(model.rest_positions.size(), kFree);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyPart& body = model.bodies[b];
    const auto is_inside = [&](std::uint32_t v) {
      return v >= body.vertex_begin && v < body.vertex_begin + body.vertex_count;
    };
    const auto add = [&](const std::vector<std::uint32_t>& vertices, std::optional<std::size_t> motion) {
      for (const std::uint32_t v : vertices)
        if (is_inside(v)) support_of[v] = supports.size();
      if (std::any_of(vertices.begin(), vertices.end(), is_inside)) supports.push_back({b, motion});
    };
    add(model.fixed, std::nullopt);
    std::size_t motions = 0;
    for (const Motion& motion : model.motions)
      if (!motion.vertices.empty() && is_inside(motion.vertices.front())) add(motion.vertices, motions++);
  }
  if (supports.empty()) return supports;
  const std::vector<double> mass = lumped_masses(model);
  for (std::size_t v = 0; v < mass.size(); ++v)
    if (support_of[v] != kFree) supports[support_of[v]].force -= mass[v] * model.gravity;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const Tet& tet = model.tets[t];
    if (std::all_of(tet.begin(), tet.end(), [&](std::uint32_t v) { return support_of[v] == kFree; })) continue;
    const LinearTet rest(gather(model.rest_positions, tet));
    const Derivatives d = elastic(rest, gather(state.displacement, tet), model.materials[model.tet_material[t]], 0,
                                  Eigen::Matrix3d::Zero(), false, false);
    for (int a = 0; a < 4; ++a)
      if (support_of[tet[a]] != kFree) supports[support_of[tet[a]]].force += d.gradient.segment<3>(3 * a);
  }
  return supports;
}

StateFields export_fields(const Model& model, const State& state) {
  StateFields fields;
  fields.displacement = state.displacement;
  fields.velocity = state.velocity;
  const std::size_t tet_count = model.file_mesh.tets.size();
  fields.green_strain.assign(tet_count, Vector6d::Zero());
  fields.von_mises.assign(tet_count, 0);
  fields.det_f.assign(tet_count, 1);
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const LinearTet rest(gather(model.rest_positions, model.tets[t]));
    const Eigen::Matrix3d f = rest.deformation_gradient(gather(state.displacement, model.tets[t]));
    const std::uint32_t source = model.tet_source[t];
    fields.green_strain[source] = green_strain(f);
    fields.von_mises[source] = von_mises(f, model.materials[model.tet_material[t]]);
    fields.det_f[source] = f.determinant();
  }
  return fields;
}

}  // namespace fascia::reference
