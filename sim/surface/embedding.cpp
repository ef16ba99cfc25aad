#include "sim/surface/embedding.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "sim/elements/quadratic_tet.h"
#include "sim/mesh/tet_faces.h"
#include "sim/surface/triangle_tree.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// Weights of points in one tet.
class Barycentric {
 public:
  Barycentric(const Tet& tet, const std::vector<Vector3d>& x) : origin_(x[tet[0]]) {
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k) edges.col(k) = x[tet[k + 1]] - x[tet[0]];
    inverse_ = edges.inverse();
  }
  Eigen::Vector4d of(const Vector3d& p) const {
    const Vector3d w = inverse_ * (p - origin_);
    return {1 - w.sum(), w.x(), w.y(), w.z()};
  }

 private:
  Vector3d origin_;
  Eigen::Matrix3d inverse_;
};

// Cells of about one tet each; every cell lists the tets whose bounding boxes touch it.
class Grid {
 public:
  Grid(const std::vector<Vector3d>& x, const std::vector<Tet>& tets) {
    min_.setConstant(1e300);
    Vector3d max = -min_;
    for (const Tet& tet : tets)
      for (const auto v : tet) {
        min_ = min_.cwiseMin(x[v]);
        max = max.cwiseMax(x[v]);
      }
    const Vector3d size = (max - min_).cwiseMax(1e-30);
    cell_ = std::cbrt(size.prod() / static_cast<double>(tets.size()));
    cell_ = std::max(cell_, size.maxCoeff() / 256);  // limits memory for thin bodies
    count_ = (size / cell_).array().ceil().cast<int>().max(1).min(257).matrix();
    cells_.resize(static_cast<std::size_t>(count_.prod()));
    for (std::uint32_t t = 0; t < tets.size(); ++t) {
      Vector3d low = x[tets[t][0]], high = low;
      for (const auto v : tets[t]) {
        low = low.cwiseMin(x[v]);
        high = high.cwiseMax(x[v]);
      }
      for_cells(cell_of(low), cell_of(high), [&](std::vector<std::uint32_t>& cell) { cell.push_back(t); });
    }
  }

  Vector3i cell_of(const Vector3d& p) const {
    const Vector3d scaled = (p - min_) / cell_;
    Vector3i cell;
    for (int k = 0; k < 3; ++k) cell[k] = static_cast<int>(std::clamp(std::floor(scaled[k]), 0.0, count_[k] - 1.0));
    return cell;
  }

  template <class F>
  void for_cells(const Vector3i& low, const Vector3i& high, F f) {
    for (int i = low.x(); i <= high.x(); ++i)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int k = low.z(); k <= high.z(); ++k)
          f(cells_[(static_cast<std::size_t>(i) * count_.y() + j) * count_.z() + k]);
  }

  const std::vector<std::uint32_t>& at(const Vector3d& p) const {
    const Vector3i cell = cell_of(p);
    return cells_[(static_cast<std::size_t>(cell.x()) * count_.y() + cell.y()) * count_.z() + cell.z()];
  }

 private:
  Vector3d min_;
  double cell_;
  Vector3i count_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

QuadraticTie linear_tie(const EmbeddedPoint& tie) {
  QuadraticTie same;
  std::copy(tie.weights.begin(), tie.weights.end(), same.weights.begin());
  return same;
}

std::array<double, 4> as_array(const Eigen::Vector4d& w) { return {w[0], w[1], w[2], w[3]}; }

}  // namespace

EmbeddedPoints embed(std::vector<Vector3d> points, const std::vector<Vector3d>& vertices, const std::vector<Tet>& tets,
                     const std::vector<MidEdges>& mid_edges) {
  EmbeddedPoints result;
  if (points.empty()) return result;
  Grid grid(vertices, tets);
  std::vector<Barycentric> frames;
  frames.reserve(tets.size());
  for (const Tet& tet : tets) frames.emplace_back(tet, vertices);
  const TriangleTree boundary(vertices, boundary_triangles(tets));
  const std::vector<std::uint32_t> behind = tets_at_boundary(tets);

  result.ties.reserve(points.size());
  for (const Vector3d& p : points) {
    std::uint32_t home = 0;
    double deepest = -1;
    for (const std::uint32_t t : grid.at(p)) {
      const double smallest = frames[t].of(p).minCoeff();
      if (smallest <= deepest) continue;
      deepest = smallest;
      home = t;
    }
    Eigen::Vector4d weights = frames[home].of(p), foot = weights;
    if (deepest < 0) {
      const TriangleTree::Nearest nearest = boundary.nearest(p);
      home = behind[nearest.triangle];
      foot = frames[home].of(nearest.point);
      const Eigen::Vector4d reach = frames[home].of(p) - foot;
      weights = foot + reach * std::min(1.0, kLargestReach / reach.cwiseAbs().maxCoeff());
      ++result.outside;
      result.farthest = std::max(result.farthest, nearest.distance);
    }
    result.ties.push_back({tets[home], as_array(weights)});
    if (mid_edges.empty()) continue;
    if (mid_edges[home] == kNoMidEdges)
      result.quadratic.push_back(linear_tie(result.ties.back()));
    else
      result.quadratic.push_back({mid_edges[home], QuadraticTet::shape_functions(foot, weights - foot)});
  }
  result.points = std::move(points);
  return result;
}

std::vector<Vector3d> at_points(const EmbeddedPoints& points, const std::vector<Vector3d>& of_vertices) {
  std::vector<Vector3d> values;
  values.reserve(points.ties.size());
  for (std::size_t i = 0; i < points.ties.size(); ++i) {
    const Tet& corners = points.ties[i].vertices;
    const QuadraticTie tie = points.quadratic.empty() ? linear_tie(points.ties[i]) : points.quadratic[i];
    Vector3d value = Vector3d::Zero();
    for (std::size_t a = 0; a < 4; ++a) value += tie.weights[a] * of_vertices[corners[a]];
    for (std::size_t a = 0; a < 6 && tie.middles != kNoMidEdges; ++a)
      value += tie.weights[4 + a] * of_vertices[tie.middles[a]];
    values.push_back(value);
  }
  return values;
}

void append(EmbeddedPoints& points, const EmbeddedPoints& more) {
  const auto add_ties = [&](const EmbeddedPoints& of) {
    if (of.quadratic.empty())
      std::transform(of.ties.begin(), of.ties.end(), std::back_inserter(points.quadratic), linear_tie);
    else
      points.quadratic.insert(points.quadratic.end(), of.quadratic.begin(), of.quadratic.end());
  };
  if (points.quadratic.empty() && !more.quadratic.empty()) add_ties(points);
  if (!points.quadratic.empty() || !more.quadratic.empty()) add_ties(more);
  points.points.insert(points.points.end(), more.points.begin(), more.points.end());
  points.ties.insert(points.ties.end(), more.ties.begin(), more.ties.end());
  points.outside += more.outside;
  points.farthest = std::max(points.farthest, more.farthest);
}

}  // namespace fascia
