#include "sim/grab/interactive_grab.h"

#include <algorithm>
#include <cmath>

#include "sim/grab/resolve_grab.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kReach = 0.5;      // lead of the springs over the tissue, in scene radii
constexpr double kStride = 0.1;     // of the targets in one step, in scene radii, for any length of the step
constexpr double kFirstPush = 0.5;  // initial depth, in patch radii

Vector3d shortened(const Vector3d& v, double length) {
  const double norm = v.norm();
  return norm > length ? Vector3d(v * (length / norm)) : v;
}

// The hit point in terms of the vertices that define it: corners of a boundary triangle, of the tet below an embedded
// one, or of the tet that was cut.
EmbeddedPoint place_of(const Model& model, const VisualSurface& surface, std::span<const Vector3d> positions,
                       const Hit& hit) {
  if (hit.on_cut) return tet_at(model.tets, positions, hit.point);
  const Triangle& t = surface.triangles[hit.triangle];
  const Vector3d &a = positions[t[0]], ab = positions[t[1]] - a, ac = positions[t[2]] - a, normal = ab.cross(ac),
                 at = hit.point - a;
  const double area2 = normal.squaredNorm();
  const double v = area2 > 0 ? at.cross(ac).dot(normal) / area2 : 0,
               w = area2 > 0 ? ab.cross(at).dot(normal) / area2 : 0, u = 1 - v - w;
  if (t[0] < model.rest_positions.size()) return {{t[0], t[1], t[2], t[0]}, {u, v, w, 0}};
  const auto& rest = surface.rest_positions;
  const BodyPart& body =
      model.bodies[body_of(model, model.embedded.ties[t[0] - model.rest_positions.size()].vertices[0])];
  return tet_at(std::span(model.tets).subspan(body.tet_begin, body.tet_count), model.rest_positions,
                u * rest[t[0]] + v * rest[t[1]] + w * rest[t[2]]);
}

}  // namespace

bool Grab::take(const Model& model, const VisualSurface& surface, std::span<const Vector3d> positions, const Hit& hit,
                double scene_radius, const GrabSettings& settings) {
  release();
  scene_radius_ = scene_radius;
  place_ = place_of(model, surface, positions, hit);
  taken_.assign(positions.begin(), positions.begin() + static_cast<std::ptrdiff_t>(model.rest_positions.size()));
  start_ = plane_ = pointer_ = hit.point;
  if (!grip(model, settings)) return false;
  if (!settings.push) return true;
  push_ = hit.normal.norm() > 0;
  if (push_) inward_ = -hit.normal;
  go_deeper(kFirstPush * radius_, inward_);
  return true;
}

bool Grab::grip(const Model& model, const GrabSettings& settings) {
  const double radius = settings.radius * scene_radius_;
  const std::vector<PatchVertex> patch = grab_patch(model, taken_, start_, radius, place_);
  if (patch.empty()) return false;
  radius_ = radius;
  stiffness_ = patch_stiffness(patch, radius_, settings.grip);
  patch_.clear();
  for (const PatchVertex& p : patch)
    patch_.push_back({p.vertex, taken_[p.vertex] - model.rest_positions[p.vertex], p.share * stiffness_});
  return true;
}

void Grab::set_size(const Model& model, const GrabSettings& settings) {
  const Vector3d lead = force_ / stiffness_;
  grip(model, settings);
  force_ = lead * stiffness_;  // until the next observation: the patch has not moved
}

void Grab::point_at(const Ray& ray, const Vector3d& forward) {
  const double slope = ray.direction.dot(forward);
  if (slope > 1e-6) pointer_ = ray.origin + ray.direction * ((plane_ - ray.origin).dot(forward) / slope);
}

void Grab::go_deeper(double depth, const Vector3d& forward) {
  const Vector3d way = depth * (push_ ? inward_ : forward);
  plane_ += way;
  pointer_ += way;
}

std::vector<GrabSpring> Grab::springs(double time_step, std::uint32_t grab) {
  const Vector3d where = anchor(), wanted = where + shortened(pointer_ - where, kReach * scene_radius_);
  offset_ += shortened(wanted - target(), std::min(kGrabSpeed * time_step, kStride) * scene_radius_);
  std::vector<GrabSpring> springs;
  springs.reserve(patch_.size());
  for (const Grip& grip : patch_) springs.push_back({grip.vertex, grip.displacement + offset_, grip.stiffness, grab});
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

ScriptedGrab Grab::as_scripted(const Model& model) const {
  constexpr double kDuration = 0.5;  // [s], or longer where the tissue could not follow
  ScriptedGrab scripted;
  Vector3d at(0, 0, 0);
  for (std::size_t k = 0; k < place_.vertices.size(); ++k)
    at += place_.weights[k] * model.rest_positions[place_.vertices[k]];
  scripted.where = at;
  scripted.radius = radius_;
  scripted.stiffness = stiffness_;
  scripted.translate = target() - at;
  scripted.duration = kDuration;
  scripted.smooth = true;
  return scripted;
}

}  // namespace fascia
