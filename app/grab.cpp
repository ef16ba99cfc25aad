#include "app/grab.h"

#include <algorithm>
#include <cmath>

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kReach = 0.5;   // lead of the springs over the tissue, in scene radii
constexpr double kSpeed = 10;    // of the springs' targets, in scene radii per second
constexpr double kStride = 0.1;  // of the targets in one step, in scene radii, however long the step

const BodyPart& body_of(const Model& model, std::uint32_t vertex) {
  for (const BodyPart& body : model.bodies)
    if (vertex < body.vertex_begin + body.vertex_count) return body;
  return model.bodies.back();
}

// Mean Young's modulus of the tets around every vertex of a body; 0 where there are none.
std::vector<double> local_stiffness(const Model& model, const BodyPart& body) {
  std::vector<double> sum(body.vertex_count, 0.0), count(body.vertex_count, 0.0);
  for (std::uint32_t t = body.tet_begin; t < body.tet_begin + body.tet_count; ++t)
    for (const std::uint32_t v : model.tets[t]) {
      sum[v - body.vertex_begin] += model.materials[model.tet_material[t]].young_modulus;
      count[v - body.vertex_begin] += 1;
    }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = count[i] > 0 ? sum[i] / count[i] : 0;
  return sum;
}

Vector3d shortened(const Vector3d& v, double length) {
  const double norm = v.norm();
  return norm > length ? Vector3d(v * (length / norm)) : v;
}

}  // namespace

bool Grab::take(const Model& model, std::span<const Vector3d> positions, const Triangle& triangle, const Hit& hit,
                double scene_radius, const GrabSettings& settings) {
  release();
  const auto mesh_vertices = static_cast<std::uint32_t>(model.rest_positions.size());
  const auto distance2 = [&](std::uint32_t v) { return (positions[v] - hit.point).squaredNorm(); };
  // A triangle of an embedded surface has no mesh vertices: the nearest one then tells which body was hit.
  std::uint32_t seed = triangle[0];
  if (seed >= mesh_vertices) {
    seed = 0;
    for (std::uint32_t v = 1; v < mesh_vertices; ++v)
      if (distance2(v) < distance2(seed)) seed = v;
  }
  const BodyPart& body = body_of(model, seed);
  const std::vector<char> held = model.held();
  const std::vector<double> modulus = local_stiffness(model, body);
  const double radius = settings.radius * scene_radius;

  double weights = 0;
  for (std::uint32_t v = body.vertex_begin; v < body.vertex_begin + body.vertex_count; ++v) {
    if (held[v] || modulus[v - body.vertex_begin] == 0) continue;
    // Firm in the middle, fading to the rim; corners of the triangle that was hit are always part of it.
    const double inside = 1 - distance2(v) / (radius * radius);
    const bool corner = v == seed || std::count(triangle.begin(), triangle.end(), v) > 0;
    const double weight = std::max(inside > 0 ? inside * inside : 0, corner ? 0.1 : 0);
    if (weight == 0) continue;
    weights += weight;
    patch_.push_back({v, positions[v] - model.rest_positions[v],
                      weight * settings.grip * modulus[v - body.vertex_begin] * radius});
  }
  if (patch_.empty()) return false;
  stiffness_ = 0;
  for (Grip& grip : patch_) stiffness_ += grip.stiffness /= weights;
  reach_ = kReach * scene_radius;
  start_ = pointer_ = hit.point;
  return true;
}

void Grab::point_at(const Ray& ray, const Vector3d& forward) {
  const double slope = ray.direction.dot(forward);
  if (slope > 1e-6) pointer_ = ray.origin + ray.direction * ((start_ - ray.origin).dot(forward) / slope);
}

std::vector<GrabSpring> Grab::springs(double time_step) {
  const double radius = reach_ / kReach;
  const Vector3d where = anchor(), wanted = where + shortened(pointer_ - where, reach_);
  offset_ += shortened(wanted - target(), std::min(kSpeed * time_step, kStride) * radius);
  std::vector<GrabSpring> springs;
  springs.reserve(patch_.size());
  for (const Grip& grip : patch_) springs.push_back({grip.vertex, grip.displacement + offset_, grip.stiffness});
  return springs;
}

void Grab::observe(const Vector3d& force) {
  if (force.allFinite()) force_ = force;
}

std::vector<std::uint32_t> Grab::vertices() const {
  std::vector<std::uint32_t> vertices;
  for (const Grip& grip : patch_) vertices.push_back(grip.vertex);
  return vertices;
}

GrabMark Grab::mark() const { return {anchor().cast<float>(), pointer_.cast<float>()}; }

}  // namespace fascia
