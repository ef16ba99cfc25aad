// Measures a state of the reference solver: energies, momenta, reactions, strains and stresses.
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "sim/reference/newton.h"
#include "sim/reference/quadratic_elasticity.h"

namespace fascia::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Corners gather(const std::vector<Vector3d>& vectors, const Tet& tet) {
  return {vectors[tet[0]], vectors[tet[1]], vectors[tet[2]], vectors[tet[3]]};
}

QuadraticTet::Nodes gather(const std::vector<Vector3d>& vectors, const ElementVertices& element) {
  QuadraticTet::Nodes nodes;
  for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n] = vectors[element[n]];
  return nodes;
}

/// Of a field at the vertices of a quadratic tet.
Vector3d at_centroid(const std::vector<Vector3d>& field, const ElementVertices& element) {
  Vector3d sum(0, 0, 0);
  for (std::size_t n = 0; n < element.size(); ++n) sum += QuadraticTet::at_centroid(n) * field[element[n]];
  return sum;
}

/// Calls add(vertex, force) for held vertices beside free ones of a tet: what each passes on to the mass at the
/// centroid [N], of MovingMasses::centroid.
template <class Add>
void pass_on_inertia(const Model& model, const State& state, const std::vector<double>& centroid, const Add& add) {
  if (state.acceleration.empty()) return;
  const std::vector<char> held = model.held();
  for (std::size_t t = 0; t < centroid.size(); ++t) {
    if (centroid[t] == 0) continue;
    const ElementVertices element = model.element(t);
    if (std::all_of(element.begin(), element.end(), [&](std::uint32_t v) { return held[v]; })) continue;
    const Vector3d force = centroid[t] * at_centroid(state.acceleration, element);
    for (std::size_t n = 0; n < element.size(); ++n)
      if (held[element[n]]) add(element[n], QuadraticTet::at_centroid(n) * force);
  }
}

LinearTet corners_at_rest(const Model& model, std::size_t t) {
  return LinearTet(gather(model.rest_positions, model.tets[t]));
}

/// Energy [J] of one tet and its gradient [N] at each of its vertices.
struct TetForces {
  double energy = 0;
  std::array<Vector3d, QuadraticTet::kNodes> gradient;
};

TetForces forces_of(const Model& model, const LinearTet& rest, const State& state, std::size_t t) {
  const Material& material = model.materials[model.tet_material[t]];
  TetForces forces;
  const auto take = [&]<int n>(const ElementDerivatives<n>& d) {
    forces.energy = d.energy;
    for (int a = 0; a < n; ++a) forces.gradient[static_cast<std::size_t>(a)] = d.gradient.template segment<3>(3 * a);
  };
  if (model.is_quadratic(t))
    take(elastic(QuadraticTet(rest), gather(state.displacement, model.element(t)), material, 0, no_strains(), false,
                 false));
  else
    take(elastic(rest, gather(state.displacement, model.tets[t]), material, 0, Matrix3d::Zero(), false, false));
  return forces;
}

/// Volume of a tet times its mean squared strain, its J, and what is largest at one of its points.
struct TetShape {
  double squared_strain, growth;
  VolumeRatios det_f;
  double strain = 0, von_mises = 0;
};

TetShape shape_of(const Model& model, const LinearTet& rest, const State& state, std::size_t t) {
  const Material& material = model.materials[model.tet_material[t]];
  if (!model.is_quadratic(t)) {
    const Corners u = gather(state.displacement, model.tets[t]);
    const Matrix3d f = rest.deformation_gradient(u);
    const double det_f = f.determinant(), strain = green_strain_matrix(rest, u).norm();
    return {rest.volume * strain * strain, rest.volume * (det_f - 1), {det_f, det_f}, strain, von_mises(f, material)};
  }
  const QuadraticTet tet(rest);
  const QuadraticTet::Nodes u = gather(state.displacement, model.element(t));
  TetShape shape{0, 0, volume_ratios(tet, u, true)};
  const std::vector<Matrix3d> stresses = first_piola_stresses(tet, u, material, QuadraticTet::points());
  const QuadraticTet::PointGradients at_points = tet.at_points(u);
  for (std::size_t q = 0; q < at_points.size(); ++q) {
    const Matrix3d f = Matrix3d::Identity() + at_points[q];
    const double strain = strain_of(at_points[q]).norm();
    shape.squared_strain += 0.25 * tet.volume * strain * strain;
    shape.growth += 0.25 * tet.volume * (f.determinant() - 1);
    shape.strain = std::max(shape.strain, strain);
    shape.von_mises = std::max(shape.von_mises, von_mises(f, stresses[q]));
  }
  return shape;
}

}  // namespace

Measures measure(const Model& model, const State& state, const std::vector<Vector3d>& contact) {
  Measures result;
  double strain2 = 0, volume = 0, growth = 0;
  const std::vector<double> mass = consistent_masses(model);
  const MovingMasses moving = moving_masses(model);
  const std::vector<char> held = model.held();
  const auto add_motion = [&](double of, const Vector3d& position, const Vector3d& velocity) {
    const Vector3d momentum = of * velocity;
    result.kinetic += 0.5 * momentum.dot(velocity);
    result.momentum += momentum;
    result.angular_momentum += position.cross(momentum);
  };
  for (std::size_t t = 0; t < moving.centroid.size(); ++t) {
    if (moving.centroid[t] == 0) continue;
    const ElementVertices element = model.element(t);
    add_motion(moving.centroid[t],
               at_centroid(model.rest_positions, element) + at_centroid(state.displacement, element),
               at_centroid(state.velocity, element));
  }
  for (std::size_t v = 0; v < mass.size(); ++v) {
    add_motion(moving.own[v], model.rest_positions[v] + state.displacement[v], state.velocity[v]);
    result.gravitational -= mass[v] * model.gravity.dot(state.displacement[v]);
    if (held[v]) result.fixed_reaction -= mass[v] * model.gravity;
    if (held[v] && !contact.empty()) result.fixed_reaction -= contact[v];
  }
  pass_on_inertia(model, state, moving.centroid,
                  [&](std::uint32_t, const Vector3d& force) { result.fixed_reaction += force; });
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const LinearTet rest = corners_at_rest(model, t);
    const TetForces forces = forces_of(model, rest, state, t);
    result.elastic += forces.energy;
    const ElementVertices element = model.element(t);
    for (std::size_t a = 0; a < element.size(); ++a)
      if (held[element[a]]) result.fixed_reaction += forces.gradient[a];
    const TetShape shape = shape_of(model, rest, state, t);
    strain2 += shape.squared_strain;
    result.max_strain = std::max(result.max_strain, shape.strain);
    result.max_von_mises = std::max(result.max_von_mises, shape.von_mises);
    volume += rest.volume;
    result.min_det_f = t == 0 ? shape.det_f.min : std::min(result.min_det_f, shape.det_f.min);
    result.max_det_f = t == 0 ? shape.det_f.max : std::max(result.max_det_f, shape.det_f.max);
    growth += shape.growth;
    result.inverted += shape.det_f.min <= 0;
  }
  if (volume > 0) {
    result.rms_strain = std::sqrt(strain2 / volume);
    result.volume_ratio = 1 + growth / volume;
  }
  return result;
}

std::vector<Support> support_forces(const Model& model, const State& state, const std::vector<Vector3d>& contact) {
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
  const std::vector<double> mass = consistent_masses(model);
  for (std::size_t v = 0; v < mass.size(); ++v)
    if (support_of[v] != kFree) {
      supports[support_of[v]].force -= mass[v] * model.gravity;
      if (!contact.empty()) supports[support_of[v]].force -= contact[v];
    }
  if (!state.acceleration.empty())
    pass_on_inertia(model, state, moving_masses(model).centroid,
                    [&](std::uint32_t v, const Vector3d& force) { supports[support_of[v]].force += force; });
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const ElementVertices element = model.element(t);
    if (std::all_of(element.begin(), element.end(), [&](std::uint32_t v) { return support_of[v] == kFree; })) continue;
    const TetForces forces = forces_of(model, corners_at_rest(model, t), state, t);
    for (std::size_t a = 0; a < element.size(); ++a)
      if (support_of[element[a]] != kFree) supports[support_of[element[a]]].force += forces.gradient[a];
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
    const LinearTet rest = corners_at_rest(model, t);
    const Material& material = model.materials[model.tet_material[t]];
    const std::uint32_t source = model.tet_source[t];
    Matrix3d f;
    if (model.is_quadratic(t)) {
      const QuadraticTet tet(rest);
      const QuadraticTet::Nodes u = gather(state.displacement, model.element(t));
      f = Matrix3d::Identity() + tet.at_centroid(u);
      fields.von_mises[source] = von_mises(f, first_piola_stress(tet, u, material));
    } else {
      f = rest.deformation_gradient(gather(state.displacement, model.tets[t]));
      fields.von_mises[source] = von_mises(f, material);
    }
    fields.green_strain[source] = green_strain(f);
    fields.det_f[source] = f.determinant();
  }
  return fields;
}

}  // namespace fascia::reference
