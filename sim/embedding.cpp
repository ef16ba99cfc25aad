#include "sim/embedding.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

std::array<double, 4> barycentric(const Vector3d& p, const Tet& tet, const std::vector<Vector3d>& x) {
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k) edges.col(k) = x[tet[k + 1]] - x[tet[0]];
  const Vector3d w = edges.inverse() * (p - x[tet[0]]);
  return {1 - w.sum(), w.x(), w.y(), w.z()};
}

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
    cell_ = std::max(cell_, size.maxCoeff() / 256);  // bounded memory for thin bodies
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

  const Vector3i& count() const { return count_; }

 private:
  Vector3d min_;
  double cell_;
  Vector3i count_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace

std::vector<EmbeddedPoint> embed(const std::vector<Vector3d>& points, const std::vector<Vector3d>& vertices,
                                 const std::vector<Tet>& tets) {
  Grid grid(vertices, tets);
  std::vector<EmbeddedPoint> result;
  result.reserve(points.size());
  for (const Vector3d& p : points) {
    const Vector3i home = grid.cell_of(p);
    double best = -1e300;
    EmbeddedPoint embedded{};
    // Widen the search until some tet is seen, then once more: a tet of the next ring can still be nearer.
    bool found = false;
    for (int ring = 0; ring <= grid.count().maxCoeff(); ++ring) {
      const bool last = found;
      const Vector3i low = (home.array() - ring).max(0), high = (home.array() + ring).min(grid.count().array() - 1);
      grid.for_cells(low, high, [&](const std::vector<std::uint32_t>& cell) {
        for (const std::uint32_t t : cell) {
          const std::array<double, 4> w = barycentric(p, tets[t], vertices);
          const double smallest = *std::min_element(w.begin(), w.end());
          found = true;
          if (smallest <= best) continue;
          best = smallest;
          embedded = {tets[t], w};
        }
      });
      if (last || best >= 0) break;
    }
    result.push_back(embedded);
  }
  return result;
}

}  // namespace fascia
