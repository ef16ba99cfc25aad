// Models of bodies that may touch each other.
#pragma once
#include <Eigen/Geometry>
#include <cmath>

#include "tests/support/models.h"

namespace fascia::test {

/// The second one's vertices and tets follow those of the first; both keep their materials. Files are not merged.
inline Model beside(Model first, const Model& second, const std::string& name) {
  if (first.bodies.empty())
    first.bodies = {{"first",
                     0,
                     static_cast<std::uint32_t>(first.rest_positions.size()),
                     0,
                     static_cast<std::uint32_t>(first.tets.size()),
                     0,
                     static_cast<std::uint32_t>(first.materials.size()),
                     {}}};
  const auto vertices = static_cast<std::uint32_t>(first.rest_positions.size());
  const auto tets = static_cast<std::uint32_t>(first.tets.size());
  const auto materials = static_cast<std::uint32_t>(first.materials.size());
  const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  append(first.rest_positions, second.rest_positions);
  append(first.initial_velocity, second.initial_velocity);
  append(first.materials, second.materials);
  for (const std::string& material : second.material_names) first.material_names.push_back(name + ": " + material);
  for (Tet tet : second.tets) {
    for (std::uint32_t& v : tet) v += vertices;
    first.tets.push_back(tet);
    first.tet_source.push_back(static_cast<std::uint32_t>(first.tet_source.size()));
  }
  for (const std::uint32_t m : second.tet_material) first.tet_material.push_back(m + materials);
  for (const std::uint32_t v : second.fixed) first.fixed.push_back(v + vertices);
  const auto part_of = [](const Model& model, std::uint32_t v, std::uint32_t t, std::uint32_t m) {
    return BodyPart{"",
                    v,
                    static_cast<std::uint32_t>(model.rest_positions.size()) - v,
                    t,
                    static_cast<std::uint32_t>(model.tets.size()) - t,
                    m,
                    static_cast<std::uint32_t>(model.materials.size()) - m,
                    {}};
  };
  first.bodies.push_back(part_of(first, vertices, tets, materials));
  first.bodies.back().name = name;
  first.file_mesh.positions = first.rest_positions;
  first.file_mesh.tets = first.tets;
  first.contact.bodies = true;
  return first;
}

inline Model moved(Model model, const Eigen::Vector3d& way, const Eigen::Vector3d& velocity = {0, 0, 0}) {
  for (Eigen::Vector3d& x : model.rest_positions) x += way;
  for (Eigen::Vector3d& v : model.initial_velocity) v += velocity;
  model.file_mesh.positions = model.rest_positions;
  return model;
}

/// A cube of 0.1 m on a slab that is held from below, both on a slope down -x whose tangent is `slope`: gravity is
/// turned, not the bodies. Their meshes do not meet, and the cube is turned about y.
inline Model cube_on_slope(double slope, double friction, const Material& material) {
  const Model slab =
      make_model(make_box(10, 2, 5, {0.5, 0.1, 0.25}), material, [](const Eigen::Vector3d& x) { return x.y() < 1e-9; });
  Model cube = make_model(make_box(3, 3, 3, {0.1, 0.1, 0.1}), material, [](const Eigen::Vector3d&) { return false; });
  const Eigen::Vector3d middle(0.05, 0, 0.05);
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY()));
  for (Eigen::Vector3d& x : cube.rest_positions) x = turn * (x - middle) + Eigen::Vector3d(0.37, 0.103, 0.125);
  cube.file_mesh.positions = cube.rest_positions;
  Model model = beside(slab, cube, "cube");
  model.gravity = 9.81 / std::hypot(1, slope) * Eigen::Vector3d(-slope, -1, 0);
  model.contact.friction = friction;
  return model;
}

/// Of the second of two bodies.
inline Eigen::Vector3d mean_displacement_of_second(const Model& model, const State& state) {
  Eigen::Vector3d sum(0, 0, 0);
  const BodyPart& body = model.bodies[1];
  for (std::uint32_t v = body.vertex_begin; v < body.vertex_begin + body.vertex_count; ++v)
    sum += state.displacement[v];
  return sum / body.vertex_count;
}

}  // namespace fascia::test
