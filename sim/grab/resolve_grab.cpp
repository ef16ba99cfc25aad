#include "sim/grab/resolve_grab.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/error.h"
#include "base/suggest.h"
#include "sim/grab/grab_patch.h"
#include "sim/mesh/tet_faces.h"
#include "sim/model/vertex_selection.h"
#include "sim/scene/scene.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// Of the scene's radius, or of the patch: a point farther than both from any vertex is outside the tissue
constexpr double kNear = 0.1;

std::size_t named_body(const std::string& name, const Model& model, const std::string& where) {
  std::vector<std::string> names;
  for (const BodyPart& body : model.bodies) names.push_back(body.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (std::count(found, names.end(), name) > 1)
    throw Error(where + ".body", "two bodies are called \"" + name + "\"", "expected a \"name\" of its own for each");
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  throw Error(where + ".body", "there is no body \"" + name + "\"" + perhaps(name, names),
              "expected one of " + join(names));
}

// The nearest vertex of a tet, in the given bodies.
std::uint32_t nearest_vertex(const Model& model, const Vector3d& at, const std::vector<std::size_t>& bodies,
                             double& distance) {
  std::uint32_t nearest = 0;
  distance = std::numeric_limits<double>::infinity();
  for (const std::size_t b : bodies)
    for (std::uint32_t t = model.bodies[b].tet_begin; t < model.bodies[b].tet_begin + model.bodies[b].tet_count; ++t)
      for (const std::uint32_t v : model.tets[t])
        if (const double d = (model.rest_positions[v] - at).norm(); d < distance) {
          distance = d;
          nearest = v;
        }
  return nearest;
}

// The tets of one body with the numbering of the whole model.
Model only_body(const Model& model, std::size_t b) {
  Model part;
  part.rest_positions = model.rest_positions;
  const auto first = model.tets.begin() + model.bodies[b].tet_begin;
  part.tets.assign(first, first + model.bodies[b].tet_count);
  return part;
}

double squared_distance(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a);
  const auto beyond = [&](const Vector3d& from, const Vector3d& to) {
    return (to - from).cross(p - from).dot(normal) < 0;
  };
  const bool inside = !beyond(a, b) && !beyond(b, c) && !beyond(c, a);
  if (inside && normal.norm() > 0) return std::pow((p - a).dot(normal.normalized()), 2);
  const auto to_segment = [&](const Vector3d& from, const Vector3d& to) {
    const Vector3d along = to - from;
    const double length2 = along.squaredNorm(),
                 share = length2 > 0 ? std::clamp((p - from).dot(along) / length2, 0.0, 1.0) : 0;
    return (p - from - share * along).squaredNorm();
  };
  return std::min({to_segment(a, b), to_segment(b, c), to_segment(c, a)});
}

// Outward normal: the mean over the boundary triangles nearest to the point, weighted by area.
Vector3d surface_normal(const std::vector<Tet>& tets, const std::vector<Vector3d>& x, const Vector3d& at,
                        double radius) {
  const std::vector<Triangle> triangles = boundary_triangles(tets);
  std::vector<double> distance2;
  for (const Triangle& t : triangles) distance2.push_back(squared_distance(at, x[t[0]], x[t[1]], x[t[2]]));
  const double nearest2 = *std::min_element(distance2.begin(), distance2.end());
  Vector3d sum(0, 0, 0);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    sum += std::exp((nearest2 - distance2[i]) / (radius * radius)) * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]);
  }
  return sum.norm() > 0 ? Vector3d(sum.normalized()) : Vector3d(0, 0, 0);
}

// Keys in seconds of the scene, with later times where the motion would be too fast.
std::vector<ScriptedGrab::Key> slowed(const std::vector<ScriptedGrab::Key>& keys, double start, double fastest) {
  std::vector<ScriptedGrab::Key> path{{start, {0, 0, 0}}};
  for (const ScriptedGrab::Key& key : keys) {
    const double way = (key.displacement - path.back().displacement).norm();
    path.push_back({std::max(start + key.time, path.back().time + way / fastest), key.displacement});
  }
  return path;
}

std::string printed(const Vector3d& v) {
  char text[100];
  std::snprintf(text, sizeof text, "(%g, %g, %g)", v.x(), v.y(), v.z());
  return text;
}

struct Place {
  std::vector<PatchVertex> patch;
  double radius = 0;         // [m]
  Vector3d inward{0, 0, 0};  // of the surface at the patch; only for pushes
};

Place place_at(const ScriptedGrab& grab, const Vector3d& at, const Model& model, const std::string& where,
               double size) {
  Place place;
  place.radius = grab.radius.value_or(kPatchRadius * size);
  std::vector<std::size_t> bodies;
  if (grab.body.empty())
    for (std::size_t b = 0; b < model.bodies.size(); ++b) bodies.push_back(b);
  else
    bodies.push_back(named_body(grab.body, model, where));
  double distance = 0;
  const std::uint32_t nearest = nearest_vertex(model, at, bodies, distance);
  const Model body = only_body(model, body_of(model, nearest));
  const EmbeddedPoint tet = tet_at(body.tets, body.rest_positions, at);
  // Also true in tets larger than the patch
  const bool inside = *std::min_element(tet.weights.begin(), tet.weights.end()) >= -0.1;
  if (!inside && distance > std::max(place.radius, kNear * size)) {
    char text[64];
    std::snprintf(text, sizeof text, "%g m from the nearest vertex", distance);
    throw Error(where + ".at", text,
                "expected a place on or near the tissue, such as " + printed(model.rest_positions[nearest]));
  }
  place.patch = grab_patch(model, model.rest_positions, at, place.radius, tet);
  if (grab.push) place.inward = -surface_normal(body.tets, model.rest_positions, at, place.radius);
  return place;
}

Place place_of(const ScriptedGrab& grab, const Selection& selection, const Scene& scene, const Model& model,
               const std::string& where) {
  const std::size_t b = grab.body.empty() ? 0 : named_body(grab.body, model, where);
  const BodyPart& body = model.bodies[b];
  // Selections refer to the positions in the file, before the transform.
  TetMesh mesh;
  std::vector<MidEdges> mid_edges;
  const Eigen::Affine3d back = placement(scene.bodies[b]).inverse();
  for (std::uint32_t v = 0; v < body.vertex_count; ++v)
    mesh.positions.push_back(back * model.rest_positions[body.vertex_begin + v]);
  for (std::uint32_t t = body.tet_begin; t < body.tet_begin + body.tet_count; ++t) {
    Tet& tet = mesh.tets.emplace_back(model.tets[t]);
    for (std::uint32_t& v : tet) v -= body.vertex_begin;
    if (!model.is_quadratic(t)) continue;
    for (std::uint32_t& v : mid_edges.emplace_back(model.mid_edges[t])) v -= body.vertex_begin;
  }
  for (const auto& [name, vertices] : model.file_mesh.groups)
    for (const std::uint32_t v : vertices)
      if (v >= body.vertex_begin && v < body.vertex_begin + body.vertex_count)
        mesh.groups[name].push_back(v - body.vertex_begin);
  std::vector<std::uint32_t> vertices =
      select_vertices(selection, {mesh, mesh.tets, scene.bodies[b].up, mid_edges}, where + ".select");
  for (std::uint32_t& v : vertices) v += body.vertex_begin;
  Place place;
  place.patch = even_patch(model, vertices);
  Vector3d middle(0, 0, 0);
  for (const PatchVertex& p : place.patch) middle += p.share * model.rest_positions[p.vertex];
  for (const PatchVertex& p : place.patch)
    place.radius = std::max(place.radius, (model.rest_positions[p.vertex] - middle).norm());
  return place;
}

}  // namespace

ResolvedGrab resolve_grab(const Scene& scene, std::size_t index, const Model& model) {
  const ScriptedGrab& grab = scene.grabs[index];
  const bool of_option = index + scene.option_grabs >= scene.grabs.size();
  const std::string where =
      (of_option ? "option --grab" : scene.file.string()) + ": grabs[" + std::to_string(index) + "]";
  const double size = scene_radius(model);
  const auto* at = std::get_if<Vector3d>(&grab.where);
  const Place place = at ? place_at(grab, *at, model, where, size)
                         : place_of(grab, std::get<Selection>(grab.where), scene, model, where);
  if (place.patch.empty())
    throw Error(where, "holds only vertices that are fixed or prescribed", "expected a free one");
  const double radius = place.radius > 0 ? place.radius : kPatchRadius * size;
  const double stiffness = grab.stiffness.value_or(patch_stiffness(place.patch, radius));
  ResolvedGrab resolved;
  for (const PatchVertex& p : place.patch)
    resolved.grip.push_back(
        {p.vertex, Vector3d::Zero(), p.share * stiffness, kFirstScriptedGrab + static_cast<std::uint32_t>(index)});
  std::vector<ScriptedGrab::Key> keys = grab.path;
  if (keys.empty()) keys.push_back({grab.duration, grab.push ? Vector3d(*grab.push * place.inward) : grab.translate});
  resolved.start = grab.start;
  resolved.path = slowed(keys, grab.start,
                         kGrabSpeed * size / (grab.smooth ? 1.5 : 1));  // 1.5 times as fast in the middle
  resolved.smooth = grab.smooth;
  if (grab.release) resolved.release = *grab.release;
  return resolved;
}

}  // namespace fascia
