#include "sim/bare_mesh/stiffness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/error.h"
#include "sim/bare_mesh/flat_sides.h"
#include "sim/elements/linear_tet.h"
#include "sim/mesh/tet_faces.h"
#include "sim/model/unconstrained_parts.h"
#include "sim/reference/elastic_system.h"
#include "sim/surface/surface_fill.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr std::size_t kMostTets = 20000;  // whose factorization takes less than half a second

// What the weight may do to a body. At a strain of 0.05 every law is still close to linear. A body that turns over an
// elastic foot by m g h / k under gravity from the side topples under its weight where that is 1: a sway of 0.25 leaves
// a factor of four. So it does to the weight that buckles a column (Greenhill 1881).
constexpr double kStrain = 0.05, kPeak = 0.3, kSag = 0.1, kSway = 0.25;
constexpr double kShareAbove = 0.01;  // of the volume: specks and tips that hang on an edge move freely, and may

Model model_of(const HeldBody& body, const Material& material) {
  Model model;
  model.rest_positions = body.positions;
  model.tets = body.tets;
  model.tet_material.assign(body.tets.size(), 0);
  model.materials = {material};
  model.fixed = body.fixed;
  return model;
}

/// The same body in fewer tets: a lattice that fills its boundary, held near its fixed vertices.
HeldBody coarser(const HeldBody& body) {
  SurfaceMesh boundary;
  boundary.positions = body.positions;
  boundary.triangles = boundary_triangles(body.tets);
  FilledSurface filled = fill_surface(std::move(boundary), "the mesh", {});
  HeldBody copy;
  copy.positions = std::move(filled.file.mesh.positions);
  copy.tets = std::move(filled.file.mesh.tets);
  // Half a spacing, so that the copy is not held a layer higher than the body.
  const double cell_size = filled.repaired.report.box.sizes().maxCoeff() / filled.resolution / 2;
  const auto cell_of = [&](const Vector3d& p) {
    const Eigen::Vector3i cell = (p / cell_size).array().floor().cast<int>();
    return std::array{cell.x(), cell.y(), cell.z()};
  };
  std::set<std::array<int, 3>> held;  // the cells of fixed vertices and those around them
  for (const std::uint32_t v : body.fixed) {
    const std::array<int, 3> cell = cell_of(body.positions[v]);
    for (int k = 0; k < 27; ++k) held.insert({cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1});
  }
  std::set<std::array<int, 3>> own;
  for (const std::uint32_t v : body.fixed) own.insert(cell_of(body.positions[v]));
  for (const bool wide : {false, true}) {
    for (std::uint32_t v = 0; v < copy.positions.size(); ++v)
      if ((wide ? held : own).contains(cell_of(copy.positions[v]))) copy.fixed.push_back(v);
    if (!copy.fixed.empty()) break;
  }
  return copy;
}

/// Of a body that linear elasticity says nothing about: as that of a column as high as the body.
WeightResponse response_of_column(const HeldBody& body, double weight_density) {
  const double strain = weight_density * bulk_of(body.positions, body.tets).box.sizes().y();
  return {strain, strain, strain / 2, strain / 2};
}

struct Strains {
  double high = 0, peak = 0;
};

Strains strains_of(const HeldBody& body, const VectorXd& u) {
  std::vector<std::pair<double, double>> strain_volume;
  double volume = 0;
  for (const Tet& t : body.tets) {
    Corners rest, moved;
    for (std::size_t k = 0; k < 4; ++k) {
      rest[k] = body.positions[t[k]];
      moved[k] = u.segment<3>(3 * static_cast<Eigen::Index>(t[k]));
    }
    const LinearTet tet(rest);
    const Eigen::Matrix3d h = tet.displacement_gradient(moved);
    strain_volume.emplace_back((0.5 * (h + h.transpose())).norm(), tet.volume);
    volume += tet.volume;
  }
  std::sort(strain_volume.rbegin(), strain_volume.rend());
  Strains strains{0, strain_volume.front().first};
  double above = 0;
  for (const auto& [strain, part] : strain_volume) {
    strains.high = strain;
    if ((above += part) > kShareAbove * volume) break;
  }
  return strains;
}

/// That which kShareAbove of the mass exceeds.
double high_displacement(const VectorXd& u, const std::vector<double>& masses) {
  std::vector<std::pair<double, double>> length_mass;
  double left = 0;
  for (std::size_t v = 0; v < masses.size(); ++v) {
    length_mass.emplace_back(u.segment<3>(3 * static_cast<Eigen::Index>(v)).norm(), masses[v]);
    left += kShareAbove * masses[v];
  }
  std::sort(length_mass.rbegin(), length_mass.rend());
  for (const auto& [length, mass] : length_mass)
    if ((left -= mass) <= 0) return length;
  return 0;
}

WeightResponse solve(const HeldBody& body, const Material& material, double gravity) {
  const WeightResponse unknown = response_of_column(body, material.density * gravity);
  const Model model = model_of(body, material);
  const reference::ElasticSystem system(model);
  const std::vector<double> masses = lumped_masses(model);
  const UnconstrainedParts unheld = unconstrained_parts(model, model.held());
  double falling = 0, total = 0;
  for (std::size_t v = 0; v < masses.size(); ++v) {
    falling += unheld.part[v] == 0 ? 0 : masses[v];
    total += masses[v];
  }
  if (system.dof_count() == 0 || falling > kShareAbove * total) return unknown;
  VectorXd scale, rest = VectorXd::Zero(3 * static_cast<Eigen::Index>(body.positions.size()));
  reference::SparseMatrix stiffness = system.empty_hessian();
  system.assemble(rest, {}, false, stiffness, scale);
  reference::Cholesky factor(stiffness, system.elimination_tree());
  // The shift keeps unsupported specks from making the matrix singular, and changes nothing else.
  if (!factor.factorize(stiffness, 1e-12 * stiffness.diagonal().mean())) return unknown;
  const auto displacement = [&](const Vector3d& acceleration) {
    VectorXd force(rest.size());
    for (std::size_t v = 0; v < masses.size(); ++v)
      force.segment<3>(3 * static_cast<Eigen::Index>(v)) = masses[v] * acceleration;
    VectorXd u = rest;
    system.add_to_free(factor.solve(system.free_part(force)), 1, u);
    return u;
  };
  const Vector3d size = bulk_of(body.positions, body.tets).box.sizes();
  const VectorXd down = displacement(-gravity * Vector3d::UnitY());
  const Strains strains = strains_of(body, down);
  WeightResponse response{strains.high, strains.peak, high_displacement(down, masses) / size.maxCoeff(), 0};
  for (const Vector3d& side : {Vector3d(1, 0, 0), Vector3d(0, 0, 1)})
    response.sway = std::max(response.sway, high_displacement(displacement(gravity * side), masses) / size.y());
  return std::isfinite(response.strain + response.peak + response.sag + response.sway) ? response : unknown;
}

}  // namespace

WeightResponse weight_response(HeldBody body, const Material& material, double gravity) {
  Material unit = material;
  unit.young_modulus = 1;
  unit.damping = 0;
  unit.model = MaterialModel::st_venant_kirchhoff;  // at rest all laws agree
  if (body.tets.size() <= kMostTets) return solve(body, unit, gravity);
  try {
    const HeldBody copy = coarser(body);
    WeightResponse response = solve(copy, unit, gravity);
    // Where the lattice is too coarse its parts are thicker than those of the body, and carry their weight with the
    // square of that.
    const double thicker = bulk_of(copy.positions, copy.tets).volume / bulk_of(body.positions, body.tets).volume;
    const double factor = std::max(1.0, thicker * thicker);
    for (double* value : {&response.strain, &response.peak, &response.sag, &response.sway}) *value *= factor;
    return response;
  } catch (const Error&) {  // the boundary encloses nothing
    return response_of_column(body, unit.density * gravity);
  }
}

double modulus_for(const WeightResponse& r) {
  const double modulus = std::max({r.strain / kStrain, r.peak / kPeak, r.sag / kSag, r.sway / kSway});
  const double unit = std::pow(10, std::floor(std::log10(modulus)) - 1);
  double least = 0, most = 0;
  Material material;
  visit_material(material, [&](double& field, const char*, const char*, double min, double max, auto&&...) {
    if (&field == &material.young_modulus) least = min, most = max;
  });
  return std::clamp(std::round(modulus / unit) * unit, least, most);
}

}  // namespace fascia
