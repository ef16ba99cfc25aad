#include "sim/grab/grab_patch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "sim/mesh/mid_edges.h"
#include "sim/mesh/tet_faces.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kCorner = 0.3;  // weight of a point's own tet relative to that of vertices in the middle of the patch
constexpr double kRoundedWeight = 1e-6;  // barycentric: smaller is rounding

// Mean Young's modulus of the tets around every vertex of a body; 0 without tets.
std::vector<double> local_modulus(const Model& model, const BodyPart& body) {
  std::vector<double> sum(body.vertex_count, 0.0), count(body.vertex_count, 0.0);
  for (std::uint32_t t = body.tet_begin; t < body.tet_begin + body.tet_count; ++t)
    for (const std::uint32_t v : model.element(t)) {
      sum[v - body.vertex_begin] += model.materials[model.tet_material[t]].young_modulus;
      count[v - body.vertex_begin] += 1;
    }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = count[i] > 0 ? sum[i] / count[i] : 0;
  return sum;
}

/// The least weight of the vertices around a point in a tet, by their shape functions there.
std::map<std::uint32_t, double> weights_at(const EmbeddedPoint& place, const std::vector<MidEdge>& middles) {
  std::map<std::uint32_t, double> weights;
  const auto raise = [&](std::uint32_t v, double weight) {
    if (weight > kRoundedWeight) weights[v] = std::max(weights[v], kCorner * std::min(weight, 1.0));
  };
  std::map<std::uint32_t, double> corners;
  for (std::size_t a = 0; a < 4; ++a) corners[place.vertices[a]] += place.weights[a];
  for (std::size_t a = 0; a < 4; ++a) raise(place.vertices[a], place.weights[a]);
  for (const MidEdge& edge : middles) {
    const auto a = corners.find(edge.a), b = corners.find(edge.b);
    if (a != corners.end() && b != corners.end()) raise(edge.vertex, 4 * a->second * b->second);
  }
  return weights;
}

/// An even load on a face of a quadratic tet acts on the middles of its edges alone: corners keep a share only where no
/// middle has one.
void leave_to_middles(const std::vector<MidEdge>& middles, std::vector<PatchVertex>& patch) {
  std::set<std::uint32_t> among, ends;
  for (const MidEdge& edge : middles) {
    among.insert(edge.vertex);
    ends.insert({edge.a, edge.b});
  }
  if (std::any_of(patch.begin(), patch.end(), [&](const PatchVertex& p) { return among.contains(p.vertex); }))
    std::erase_if(patch, [&](const PatchVertex& p) { return ends.contains(p.vertex); });
}

/// Weights of an even traction [m^2] over the faces of the surface whose corners are all among `given`: a third of the
/// area at each corner, or at each mid-edge vertex of a quadratic tet. Empty where these vertices span no face.
std::map<std::uint32_t, double> traction_weights(const Model& model, const std::set<std::uint32_t>& given) {
  std::map<std::uint32_t, double> weights;
  const std::vector<Triangle> faces = boundary_triangles(model.tets);
  const std::vector<std::uint32_t> tets = tets_at_boundary(model.tets);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto [a, b, c] = faces[f];
    if (!given.contains(a) || !given.contains(b) || !given.contains(c)) continue;
    const Vector3d& x = model.rest_positions[a];
    const double third = (model.rest_positions[b] - x).cross(model.rest_positions[c] - x).norm() / 6;
    const std::uint32_t t = tets[f];
    if (!model.is_quadratic(t)) {
      for (const std::uint32_t v : faces[f]) weights[v] += third;
      continue;
    }
    const auto of_face = [&](std::size_t corner) {
      return std::find(faces[f].begin(), faces[f].end(), model.tets[t][corner]) != faces[f].end();
    };
    for (std::size_t e = 0; e < kMidEdgeCorners.size(); ++e)
      if (of_face(kMidEdgeCorners[e][0]) && of_face(kMidEdgeCorners[e][1])) weights[model.mid_edges[t][e]] += third;
  }
  return weights;
}

void make_shares_of_weights(std::vector<PatchVertex>& patch) {
  double sum = 0;
  for (const PatchVertex& p : patch) sum += p.share;
  for (PatchVertex& p : patch) p.share /= sum;
}

}  // namespace

EmbeddedPoint tet_at(std::span<const Tet> tets, std::span<const Vector3d> x, const Vector3d& p) {
  EmbeddedPoint best{};
  double best_smallest = -1e300;
  for (const Tet& tet : tets) {
    const double volume = signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]);
    if (volume == 0) continue;  // flattened
    std::array<double, 4> w{};
    double smallest = 1;
    for (std::size_t a = 0; a < 4 && smallest > best_smallest; ++a) {
      std::array<Vector3d, 4> corner{x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]};
      corner[a] = p;
      w[a] = signed_volume6(corner[0], corner[1], corner[2], corner[3]) / volume;
      smallest = std::min(smallest, w[a]);
    }
    if (smallest <= best_smallest) continue;
    best_smallest = smallest;
    best = {tet, w};
  }
  return best;
}

std::size_t body_of(const Model& model, std::uint32_t vertex) {
  for (std::size_t b = 0; b + 1 < model.bodies.size(); ++b)
    if (vertex < model.bodies[b].vertex_begin + model.bodies[b].vertex_count) return b;
  return model.bodies.size() - 1;
}

double scene_radius(const Model& model) {
  Vector3d low = Vector3d::Constant(1e300), high = -low;
  for (const Tet& tet : model.tets)
    for (const std::uint32_t v : tet) {
      low = low.cwiseMin(model.rest_positions[v]);
      high = high.cwiseMax(model.rest_positions[v]);
    }
  return 0.5 * (high - low).norm();
}

std::vector<PatchVertex> grab_patch(const Model& model, std::span<const Vector3d> positions, const Vector3d& point,
                                    double radius, const EmbeddedPoint& place) {
  const BodyPart& body = model.bodies[body_of(model, place.vertices[0])];
  const std::vector<char> held = model.held();
  const std::vector<double> modulus = local_modulus(model, body);
  const std::vector<MidEdge> middles = mid_edges_of(model.file_mesh);
  const std::map<std::uint32_t, double> least = weights_at(place, middles);
  std::vector<PatchVertex> patch;
  for (std::uint32_t v = body.vertex_begin; v < body.vertex_begin + body.vertex_count; ++v) {
    if (held[v] || modulus[v - body.vertex_begin] == 0) continue;
    const double inside = 1 - (positions[v] - point).squaredNorm() / (radius * radius);
    double weight = inside > 0 ? inside * inside : 0;
    if (const auto own = least.find(v); own != least.end()) weight = std::max(weight, own->second);
    if (weight > 0) patch.push_back({v, weight, modulus[v - body.vertex_begin]});
  }
  leave_to_middles(middles, patch);
  make_shares_of_weights(patch);
  return patch;
}

std::vector<PatchVertex> even_patch(const Model& model, const std::vector<std::uint32_t>& vertices) {
  const std::vector<char> held = model.held();
  std::vector<std::vector<double>> modulus;
  for (const BodyPart& body : model.bodies) modulus.push_back(local_modulus(model, body));
  const std::vector<MidEdge> middles = mid_edges_of(model.file_mesh);
  std::vector<std::uint32_t> all = vertices;
  const std::set<std::uint32_t> given(vertices.begin(), vertices.end());
  for (const MidEdge& edge : middles)
    if (given.contains(edge.a) && given.contains(edge.b) && !given.contains(edge.vertex)) all.push_back(edge.vertex);
  std::vector<PatchVertex> patch;
  for (const std::uint32_t v : all) {
    const std::size_t b = body_of(model, v);
    const double there = modulus[b][v - model.bodies[b].vertex_begin];
    if (!held[v] && there > 0) patch.push_back({v, 1, there});
  }
  const std::map<std::uint32_t, double> weights = traction_weights(model, given);
  const auto pulled = [&](const PatchVertex& p) { return weights.contains(p.vertex); };
  if (std::any_of(patch.begin(), patch.end(), pulled)) {
    std::erase_if(patch, std::not_fn(pulled));
    for (PatchVertex& p : patch) p.share = weights.at(p.vertex);
  } else {
    leave_to_middles(middles, patch);
  }
  make_shares_of_weights(patch);
  return patch;
}

double patch_stiffness(const std::vector<PatchVertex>& patch, double radius, double grip) {
  double modulus = 0;
  for (const PatchVertex& p : patch) modulus += p.share * p.modulus;
  return grip * modulus * radius;
}

}  // namespace fascia
