#include "sim/surface/lattice_sides.h"

#include <algorithm>
#include <array>

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr double kMargin = 1e-6;                     // spacings
constexpr std::uint32_t kPointsBetweenReports = 64;  // with long triangles each point tests all of them

/// A triangle, or its part within a box.
class Piece {
 public:
  explicit Piece(const std::array<Vector3d, 3>& corners) : size_(3) {
    std::copy(corners.begin(), corners.end(), corners_.begin());
  }

  Eigen::AlignedBox3d box() const {
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < size_; ++i) box.extend(corners_[i]);
    return box;
  }

  /// The part where sign * x[axis] <= sign * limit.
  Piece cut(int axis, double limit, double sign) const {
    Piece part;
    if (size_ + 2 > corners_.size()) return *this;  // more corners than a box can cut off come from rounding only
    for (std::size_t i = 0; i < size_; ++i) {
      const Vector3d &a = corners_[i], &b = corners_[(i + 1) % size_];
      const double da = sign * (limit - a[axis]), db = sign * (limit - b[axis]);
      if (da >= 0) part.corners_[part.size_++] = a;
      if ((da >= 0) != (db >= 0) && part.size_ < part.corners_.size())
        part.corners_[part.size_++] = a + (b - a) * (da / (da - db));
      if (part.size_ == part.corners_.size()) return *this;
    }
    return part;
  }

 private:
  Piece() = default;
  std::array<Vector3d, 16> corners_;
  std::size_t size_ = 0;
};

class CellMarker {
 public:
  CellMarker(const BccLattice& lattice, std::vector<char>& marked)
      : lattice_(lattice), marked_(marked), margin_(Vector3d::Constant(kMargin * lattice.spacing)) {}

  /// Halves the cells from `low` to `high` down to single ones: a long triangle reaches few of the cells in its box.
  void mark(const Piece& piece, Vector3i low, Vector3i high) {
    const Eigen::AlignedBox3d box = piece.box();
    if (box.isEmpty()) return;
    low = low.cwiseMax(lattice_.cell_at(box.min() - margin_));
    high = high.cwiseMin(lattice_.cell_at(box.max() + margin_));
    if ((high.array() < low.array()).any()) return;
    int axis = 0;
    const int length = (high - low).maxCoeff(&axis);
    if (length == 0) {
      marked_[lattice_.cell(low)] = 1;
      return;
    }
    const int middle = low[axis] + length / 2;
    const double plane = lattice_.origin[axis] + lattice_.spacing * (middle + 1);
    Vector3i left_high = high, right_low = low;
    left_high[axis] = middle;
    right_low[axis] = middle + 1;
    mark(piece.cut(axis, plane + margin_[axis], 1), low, left_high);
    mark(piece.cut(axis, plane - margin_[axis], -1), right_low, high);
  }

 private:
  const BccLattice& lattice_;
  std::vector<char>& marked_;
  const Vector3d margin_;
};

class SideFinder {
 public:
  SideFinder(const TriangleTree& surface, const BccLattice& lattice) : surface_(surface), lattice_(lattice) {
    side_.assign(lattice_.point_count(), outside);
    known_.assign(lattice_.point_count(), 0);
  }

  /// Points in cells without a piece of the surface have the sides of their neighbors: each such region is tested once.
  void flood_cells() {
    std::vector<char> done = cells_at_surface(surface_, lattice_);
    std::vector<Vector3i> queue;
    lattice_.for_cells(Vector3i::Zero(), lattice_.count.array() - 1, [&](const Vector3i& start) {
      if (done[lattice_.cell(start)]) return;
      const Side side = side_at(lattice_.center(start));
      done[lattice_.cell(start)] = 1;
      queue.assign(1, start);
      while (!queue.empty()) {
        const Vector3i c = queue.back();
        queue.pop_back();
        set(lattice_.center(c), side);
        lattice_.for_cells(c, c.array() + 1, [&](const Vector3i& corner) { set(lattice_.corner(corner), side); });
        for (int k = 0; k < 6; ++k) {
          const Vector3i next = c + (k % 2 ? 1 : -1) * Vector3i::Unit(k / 2);
          if ((next.array() < 0).any() || (next.array() >= lattice_.count.array()).any() || done[lattice_.cell(next)])
            continue;
          done[lattice_.cell(next)] = 1;
          queue.push_back(next);
        }
      }
    });
  }

  /// Tests the other points. If no triangle separates a point from an earlier neighbor, it has that neighbor's side:
  /// testing few triangles is faster than the winding number over all.
  void ask_points(bool balanced, const Progress& progress) {
    std::uint32_t asked = 0;
    const auto ask = [&](std::uint32_t point, const auto& neighbors) {
      if (asked++ % kPointsBetweenReports == 0)
        report(progress, asked / static_cast<double>(lattice_.point_count()), "Finding the inside of the surface");
      if (known_[point]) return;
      const auto near = balanced ? std::find_if(neighbors.begin(), neighbors.end(),
                                                [&](std::uint32_t n) { return is_beside(n, point); })
                                 : neighbors.end();
      set(point, near != neighbors.end() ? side_[*near] : side_at(point));
    };
    std::vector<std::uint32_t> neighbors;
    lattice_.for_cells(Vector3i::Zero(), lattice_.count, [&](const Vector3i& c) {
      neighbors.clear();
      for (int k = 0; k < 3; ++k)
        if (c[k] > 0) neighbors.push_back(lattice_.corner(c - Vector3i::Unit(k)));
      ask(lattice_.corner(c), neighbors);
    });
    lattice_.for_cells(Vector3i::Zero(), lattice_.count.array() - 1, [&](const Vector3i& c) {
      neighbors.clear();
      lattice_.for_cells(c, c.array() + 1,
                         [&](const Vector3i& corner) { neighbors.push_back(lattice_.corner(corner)); });
      ask(lattice_.center(c), neighbors);
    });
  }

  std::vector<Side> take() { return std::move(side_); }

 private:
  void set(std::uint32_t point, Side side) {
    side_[point] = side;
    known_[point] = 1;
  }
  Side side_at(std::uint32_t point) const { return surface_.is_inside(lattice_.position(point)) ? inside : outside; }
  /// Whether the segment between two points, slightly extended, intersects no triangle.
  bool is_beside(std::uint32_t a, std::uint32_t b) const {
    const Vector3d p = lattice_.position(a), q = lattice_.position(b), beyond = kMargin * (q - p);
    return surface_.crossings(p - beyond, q + beyond).empty();
  }

  const TriangleTree& surface_;
  const BccLattice& lattice_;
  std::vector<Side> side_;
  std::vector<char> known_;
};

}  // namespace

std::vector<char> cells_at_surface(const TriangleTree& surface, const BccLattice& lattice) {
  std::vector<char> marked(lattice.cell_count(), 0);
  CellMarker marker(lattice, marked);
  const auto& x = surface.positions();
  for (const auto& [a, b, c] : surface.triangles())
    marker.mark(Piece({x[a], x[b], x[c]}), Vector3i::Zero(), lattice.count.array() - 1);
  return marked;
}

std::vector<Side> find_sides(const TriangleTree& surface, const BccLattice& lattice, bool balanced,
                             const Progress& progress) {
  SideFinder finder(surface, lattice);
  if (balanced) finder.flood_cells();
  finder.ask_points(balanced, progress);
  return finder.take();
}

}  // namespace fascia
