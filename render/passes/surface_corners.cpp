#include "render/passes/surface_corners.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "base/error.h"

namespace fascia {
namespace {

constexpr double kCreaseCosine = 0.64;  // edges that turn by more than 50 degrees are sharp
constexpr std::uint32_t kNone = ~0u;

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

std::vector<Eigen::Vector3d> face_normals(Triangles triangles, std::span<const Eigen::Vector3d> x) {
  std::vector<Eigen::Vector3d> normals;
  normals.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) normals.push_back((x[b] - x[a]).cross(x[c] - x[a]).stableNormalized());
  return normals;
}

/// The triangles around one vertex that share its normal: those connected over edges that are not sharp.
class Fans {
 public:
  explicit Fans(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t a = root(i), b = root(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

struct Places {  // (3 * triangle + k) around every vertex, in the order of triangles
  std::vector<std::uint32_t> begin, around;

  Places(Triangles triangles, std::uint32_t vertex_count) : begin(vertex_count + 1, 0), around(3 * triangles.size()) {
    for (const auto& triangle : triangles)
      for (const std::uint32_t v : triangle) ++begin[v + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t place = 0; place < around.size(); ++place)
      around[next[triangles[place / 3][place % 3]]++] = place;
  }
  std::span<const std::uint32_t> of(std::uint32_t vertex) const {
    return {around.data() + begin[vertex], begin[vertex + 1] - begin[vertex]};
  }
};

/// For every place the first place of its fan.
std::vector<std::uint32_t> first_of_fan(Triangles triangles, std::uint32_t vertex_count,
                                        std::span<const Eigen::Vector3d> rest_positions) {
  const Places places(triangles, vertex_count);
  std::vector<std::uint32_t> first(places.around.size());
  if (rest_positions.empty()) {
    for (std::uint32_t v = 0; v < vertex_count; ++v)
      for (const std::uint32_t place : places.of(v)) first[place] = places.of(v)[0];
    return first;
  }
  const std::vector<Eigen::Vector3d> normals = face_normals(triangles, rest_positions);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> spokes;  // other vertex of an edge, index of the triangle here
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const std::span<const std::uint32_t> here = places.of(v);
    spokes.clear();
    for (std::uint32_t i = 0; i < here.size(); ++i)
      for (const std::uint32_t step : {1u, 2u})
        spokes.emplace_back(triangles[here[i] / 3][(here[i] % 3 + step) % 3], i);
    std::sort(spokes.begin(), spokes.end());
    Fans fans(here.size());
    for (std::size_t s = 1; s < spokes.size(); ++s) {
      if (spokes[s].first != spokes[s - 1].first) continue;
      const std::uint32_t i = spokes[s - 1].second, j = spokes[s].second;
      const Eigen::Vector3d &a = normals[here[i] / 3], &b = normals[here[j] / 3];
      const bool no_area = a.isZero() || b.isZero();  // such a triangle is ignored
      if (no_area || a.dot(b) > kCreaseCosine) fans.join(i, j);
    }
    for (std::uint32_t i = 0; i < here.size(); ++i) first[here[i]] = here[fans.root(i)];
  }
  return first;
}

}  // namespace

SurfaceCorners make_surface_corners(std::span<const std::array<std::uint32_t, 3>> triangles, std::uint32_t vertex_count,
                                    std::span<const Eigen::Vector3d> rest_positions,
                                    std::span<const std::uint32_t> colors) {
  for (const auto& triangle : triangles)
    for (const std::uint32_t v : triangle)
      if (v >= vertex_count)
        throw Error("surface", "a triangle has vertex " + std::to_string(v),
                    "expected vertices below " + std::to_string(vertex_count));
  if (!rest_positions.empty() && rest_positions.size() != vertex_count)
    throw Error("surface", std::to_string(rest_positions.size()) + " rest positions",
                "expected " + std::to_string(vertex_count));
  assert(colors.empty() || colors.size() == 3 * triangles.size());

  const std::vector<std::uint32_t> first = first_of_fan(triangles, vertex_count, rest_positions);
  const auto places = static_cast<std::uint32_t>(first.size());
  SurfaceCorners result;
  std::vector<std::uint32_t> newest(places, kNone);  // corner of the fan that starts at a place
  std::vector<std::uint32_t> older, fan_of;  // [corner_count] of the same fan in another color; fan's first place
  for (std::uint32_t place = 0; place < places; ++place) {
    std::uint32_t id = newest[first[place]];
    while (id != kNone && !colors.empty() && result.colors[id] != colors[place]) id = older[id];
    if (id == kNone) {
      id = static_cast<std::uint32_t>(result.vertex.size());
      older.push_back(std::exchange(newest[first[place]], id));
      fan_of.push_back(first[place]);
      result.vertex.push_back(triangles[place / 3][place % 3]);
      if (!colors.empty()) result.colors.push_back(colors[place]);
      if (!rest_positions.empty())
        result.rest.push_back(rest_positions[result.vertex.back()].cast<float>().homogeneous());
    }
    result.indices.push_back(id);
  }

  std::vector<std::uint32_t> begin(std::size_t{places} + 1, 0);  // number of places of the fan that starts at a place
  for (const std::uint32_t start : first) ++begin[start + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> around(places), next(begin.begin(), begin.end() - 1);
  for (std::uint32_t place = 0; place < places; ++place) around[next[first[place]]++] = place;
  result.fan.reserve(2 * static_cast<std::size_t>(places));
  for (const std::uint32_t start : fan_of) {
    result.fan_begin.push_back(static_cast<std::uint32_t>(result.fan.size() / 2));
    for (std::uint32_t k = begin[start]; k < begin[start + 1]; ++k) {
      const auto& triangle = triangles[around[k] / 3];
      result.fan.push_back(triangle[(around[k] % 3 + 1) % 3]);
      result.fan.push_back(triangle[(around[k] % 3 + 2) % 3]);
    }
  }
  result.fan_begin.push_back(static_cast<std::uint32_t>(result.fan.size() / 2));
  return result;
}

}  // namespace fascia
