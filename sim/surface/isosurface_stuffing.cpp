#include "sim/surface/isosurface_stuffing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "sim/mesh/tet_faces.h"
#include "sim/surface/bcc_lattice.h"
#include "sim/surface/lattice_sides.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

// A cut closer to a lattice point than these shares of a long or short edge moves the point (table 1 of the paper, for
// the best smallest angle).
constexpr double kNearLong = 0.24999, kNearShort = 0.41189;
constexpr double kMissed = 0.25;  // spacings from the tets beyond which a piece of the surface counts as missed
constexpr int kRounds = 4;        // of finding missed pieces
constexpr int kBisections = 20;
constexpr std::uint32_t kNone = ~0u;
constexpr std::size_t kTrianglesBetweenReports = 256;
constexpr const char* kFilling = "Filling the surface";

std::array<double, 4> barycentric(const Vector3d& p, const std::array<Vector3d, 4>& x) {
  const double volume = signed_volume6(x[0], x[1], x[2], x[3]);
  return {signed_volume6(p, x[1], x[2], x[3]) / volume, signed_volume6(x[0], p, x[2], x[3]) / volume,
          signed_volume6(x[0], x[1], p, x[3]) / volume, signed_volume6(x[0], x[1], x[2], p) / volume};
}

class Filler {
 public:
  Filler(const TriangleTree& surface, bool balanced, int cells, const Progress& progress)
      : surface_(surface),
        lattice_(surface.box(), cells),
        progress_(progress),
        side_(find_sides(surface, lattice_, balanced, part_of(progress, 0, 0.4))) {
    report(progress_, 0.4, kFilling);
    cut_edges();
  }

  LatticeFill fill() {
    for (int round = 0;; ++round) {
      const double begin = 0.5 + 0.1 * round;
      report(progress_, begin, kFilling);
      warp();
      emit();
      if (round == kRounds || !keep_missed(part_of(progress_, begin, begin + 0.1))) break;
    }
    out_.spacing = lattice_.spacing;
    out_.whole = kept_.size();
    if (!kept_.empty()) out_.apart = count_apart();
    return std::move(out_);
  }

 private:
  std::size_t count_apart() const {
    std::vector<char> joined(lattice_.point_count(), 0);
    lattice_.for_tets([&](const Tet& tet, std::size_t) {
      if (std::any_of(tet.begin(), tet.end(), [&](std::uint32_t point) { return now_[point] == inside; }))
        for (const std::uint32_t point : tet) joined[point] = 1;
    });
    const auto is_apart = [&](const auto& kept) {
      return std::none_of(kept.second.begin(), kept.second.end(),
                          [&](std::uint32_t point) { return joined[point] != 0; });
    };
    return static_cast<std::size_t>(std::count_if(kept_.begin(), kept_.end(), is_apart));
  }

  struct Cut {
    std::uint32_t in, out;  // lattice points
    double share;           // of the edge, from `in`
    std::uint32_t vertex;   // of the result
  };

  void cut_edges() {
    lattice_.for_tets([&](const Tet& tet, std::size_t) {
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b)
          if (side_[tet[a]] == inside && side_[tet[b]] == outside &&
              cut_of_.emplace(key(tet[a], tet[b]), cuts_.size()).second)
            cuts_.push_back({tet[a], tet[b], crossing(tet[a], tet[b]), kNone});
    });
    std::vector<std::uint32_t> ends;
    for (std::size_t c = 0; c < cuts_.size(); ++c) {
      for (const std::uint32_t point : {cuts_[c].in, cuts_[c].out}) {
        const auto [entry, is_new] = cuts_at_.emplace(point, std::vector<std::uint32_t>());
        if (is_new) near_surface_.push_back(point);
        entry->second.push_back(static_cast<std::uint32_t>(c));
      }
    }
    std::sort(near_surface_.begin(), near_surface_.end());
  }

  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }

  /// The first share of the edge from `in` at which the outside begins.
  double crossing(std::uint32_t in, std::uint32_t out) const {
    const Vector3d a = lattice_.position(in), b = lattice_.position(out);
    const std::vector<double> shares = surface_.crossings(a, b);
    if (shares.size() == 1) return shares[0];
    for (std::size_t i = 0; i + 1 < shares.size(); ++i)
      if (!surface_.is_inside(a + (b - a) * ((shares[i] + shares[i + 1]) / 2))) return shares[i];
    if (!shares.empty()) return shares.back();
    double low = 0, high = 1;  // through a hole
    for (int i = 0; i < kBisections; ++i) {
      const double middle = (low + high) / 2;
      (surface_.is_inside(a + (b - a) * middle) ? low : high) = middle;
    }
    return low;
  }

  /// Moves lattice points onto cuts that are too close, in the order of points; points of kept tets are not moved.
  void warp() {
    now_ = side_;
    moved_.clear();
    std::vector<char> pinned(lattice_.point_count(), 0);
    for (const auto& [number, tet] : kept_) {
      for (const std::uint32_t point : tet) {
        pinned[point] = 1;
        if (now_[point] == outside) now_[point] = on_surface;
      }
    }
    for (const std::uint32_t point : near_surface_) {
      if (pinned[point] || now_[point] == on_surface) continue;
      const Cut* nearest = nullptr;
      double shortest = 0;
      for (const std::uint32_t c : cuts_at_.at(point)) {
        const Cut& cut = cuts_[c];
        if (now_[cut.in] != inside || now_[cut.out] != outside) continue;
        const bool is_long = lattice_.is_long(cut.in, cut.out);
        const double share = point == cut.in ? cut.share : 1 - cut.share;
        if (share >= (is_long ? kNearLong : kNearShort)) continue;
        const double length = share * (is_long ? 1 : std::sqrt(0.75));
        if (nearest && length >= shortest) continue;
        nearest = &cut;
        shortest = length;
      }
      if (!nearest) continue;
      moved_[point] = at_share(*nearest, nearest->share);
      now_[point] = on_surface;
    }
  }

  Vector3d at_share(const Cut& cut, double share) const {
    const Vector3d a = lattice_.position(cut.in);
    return a + (lattice_.position(cut.out) - a) * share;
  }

  void emit() {
    out_.positions.clear();
    out_.tets.clear();
    vertex_of_.clear();
    for (Cut& cut : cuts_) cut.vertex = kNone;
    lattice_.for_tets([&](const Tet& tet, std::size_t number) { emit(tet, number, out_.tets); });
  }

  void emit(const Tet& tet, std::size_t number, std::vector<Tet>& tets) {
    std::array<std::uint32_t, 4> in, on, out;
    std::size_t ins = 0, ons = 0, outs = 0;
    for (const std::uint32_t point : tet) {
      if (now_[point] == inside) in[ins++] = point;
      if (now_[point] == on_surface) on[ons++] = point;
      if (now_[point] == outside) out[outs++] = point;
    }
    if (ins == 0 && (ons < 4 || !kept_.contains(number))) return;
    if (outs == 0) {
      add({vertex(tet[0]), vertex(tet[1]), vertex(tet[2]), vertex(tet[3])}, tets);
    } else if (ins == 1) {
      Tet corner{vertex(in[0]), kNone, kNone, kNone};
      for (std::size_t i = 0; i < 3; ++i) corner[i + 1] = i < ons ? vertex(on[i]) : cut(in[0], out[i - ons]);
      add(corner, tets);
    } else if (ins == 2 && outs == 1) {
      add_pyramid(vertex(on[0]), {vertex(in[0]), vertex(in[1]), cut(in[1], out[0]), cut(in[0], out[0])}, tets);
    } else if (ins == 2) {
      add_prism({vertex(in[0]), cut(in[0], out[0]), cut(in[0], out[1])},
                {vertex(in[1]), cut(in[1], out[0]), cut(in[1], out[1])}, tets);
    } else {
      add_prism({vertex(in[0]), vertex(in[1]), vertex(in[2])},
                {cut(in[0], out[0]), cut(in[1], out[0]), cut(in[2], out[0])}, tets);
    }
  }

  std::uint32_t vertex(std::uint32_t point) {
    const auto [entry, is_new] = vertex_of_.emplace(point, static_cast<std::uint32_t>(out_.positions.size()));
    if (is_new) {
      const auto moved = moved_.find(point);
      add_position(moved != moved_.end() ? moved->second : lattice_.position(point), 0);
    }
    return entry->second;
  }

  std::uint32_t cut(std::uint32_t in, std::uint32_t out) {
    Cut& cut = cuts_[cut_of_.at(key(in, out))];
    if (cut.vertex == kNone) {
      // Points of kept tets are never moved; close cuts move instead.
      const bool is_long = lattice_.is_long(in, out);
      const double nearest = is_long ? kNearLong : kNearShort;
      cut.vertex = static_cast<std::uint32_t>(out_.positions.size());
      add_position(at_share(cut, std::clamp(cut.share, nearest, 1 - nearest)), is_long ? 2 : 1);
    }
    return cut.vertex;
  }

  void add_position(const Vector3d& position, std::uint8_t rank) {
    out_.positions.push_back(position);
    rank_.resize(out_.positions.size());
    rank_.back() = rank;
  }

  // Selects the start of the diagonal of a face with four corners: the vertex of the highest rank, so that both tets at
  // the face agree and every prism can be divided. Cuts of long edges come first, then those of short ones.
  bool before(std::uint32_t a, std::uint32_t b) const { return rank_[a] != rank_[b] ? rank_[a] > rank_[b] : a < b; }

  /// `base` is in cyclic order.
  void add_pyramid(std::uint32_t apex, const std::array<std::uint32_t, 4>& base, std::vector<Tet>& tets) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < 4; ++i)
      if (before(base[i], base[first])) first = i;
    const auto around = [&](std::size_t i) { return base[(first + i) % 4]; };
    add({apex, around(0), around(1), around(2)}, tets);
    add({apex, around(0), around(2), around(3)}, tets);
  }

  /// Between two triangles whose corners correspond.
  void add_prism(std::array<std::uint32_t, 3> near, std::array<std::uint32_t, 3> far, std::vector<Tet>& tets) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < 6; ++i)
      if (before(i < 3 ? near[i] : far[i - 3], first < 3 ? near[first] : far[first - 3])) first = i;
    if (first >= 3) std::swap(near, far);
    const std::size_t a = first % 3, b = (a + 1) % 3, c = (a + 2) % 3;
    add({near[a], far[0], far[1], far[2]}, tets);
    add_pyramid(near[a], {near[b], near[c], far[c], far[b]}, tets);
  }

  void add(Tet tet, std::vector<Tet>& tets) const {
    const auto& x = out_.positions;
    if (signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) < 0) std::swap(tet[2], tet[3]);
    tets.push_back(tet);
  }

  /// Calls f with points all over a triangle, less than half a spacing apart: rows that widen from the corner opposite
  /// to its shortest side.
  template <class F>
  void for_samples(const Triangle& t, F f) const {
    const auto& x = surface_.positions();
    const std::array<double, 3> sides{(x[t[2]] - x[t[1]]).norm(), (x[t[0]] - x[t[2]]).norm(),
                                      (x[t[1]] - x[t[0]]).norm()};
    const auto [shortest, longest] = std::minmax_element(sides.begin(), sides.end());
    const auto apex = static_cast<std::size_t>(shortest - sides.begin());
    const Vector3d &a = x[t[apex]], ab = x[t[(apex + 1) % 3]] - a, ac = x[t[(apex + 2) % 3]] - a;
    const int rows = static_cast<int>(std::ceil(2 * *longest / lattice_.spacing));
    // For a long triangle each row has few points, or one
    const double widening = std::min(1.0, 2 * *shortest / *longest);
    for (int row = 0; row < rows; ++row) {
      const int points = std::max(1, static_cast<int>(std::ceil(widening * (row + 1))));
      for (int i = 0; i < points; ++i) {
        const double along = (row + 2.0 / 3) / rows, share = (i + 1.0 / 3) / (points - 1.0 / 3);
        f(Vector3d(a + ab * (along * (1 - share)) + ac * (along * share)));
      }
    }
  }

  /// Keeps the tets that contain samples far from the filling; true if there are new ones.
  bool keep_missed(const Progress& progress) {
    std::optional<TriangleTree> boundary;
    const std::size_t before = kept_.size();
    std::vector<Tet> pieces;
    const auto keep_at = [&](const Vector3d& p) {
      const auto found = tet_at(p);
      if (!found || kept_.contains(found->second)) return;
      const Tet& tet = found->first;
      if (std::all_of(tet.begin(), tet.end(), [&](std::uint32_t point) { return now_[point] == inside; })) return;
      pieces.clear();
      emit(tet, found->second, pieces);
      if (std::any_of(pieces.begin(), pieces.end(), [&](const Tet& piece) { return holds(piece, p); })) return;
      if (!boundary) boundary.emplace(out_.positions, boundary_triangles(out_.tets));
      if (!boundary->triangles().empty() && boundary->nearest(p).distance < kMissed * lattice_.spacing) return;
      kept_.emplace(found->second, tet);
    };
    const std::vector<Triangle>& triangles = surface_.triangles();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (t % kTrianglesBetweenReports == 0)
        report(progress, static_cast<double>(t) / static_cast<double>(triangles.size()), kFilling);
      for_samples(triangles[t], keep_at);
    }
    return kept_.size() > before;
  }

  bool holds(const Tet& tet, const Vector3d& p) const {
    const auto& x = out_.positions;
    const std::array<double, 4> w = barycentric(p, {x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]});
    return *std::min_element(w.begin(), w.end()) >= 0;
  }

  /// The lattice's tet around a point, and its number: through the nearest face of its cell, at the nearest edge of
  /// that face.
  std::optional<std::pair<Tet, std::size_t>> tet_at(const Vector3d& p) const {
    const Vector3i home = lattice_.cell_at(p);
    const Vector3d from_center = p - lattice_.position(lattice_.center(home));
    int axis = 0;
    from_center.cwiseAbs().maxCoeff(&axis);
    const double u = from_center[(axis + 1) % 3], v = from_center[(axis + 2) % 3];
    const int edge = std::abs(u) > std::abs(v) ? (u > 0 ? 1 : 3) : (v > 0 ? 2 : 0);
    std::optional<std::pair<Tet, std::size_t>> found;
    const Vector3i face = from_center[axis] > 0 ? home : Vector3i(home - Vector3i::Unit(axis));
    if (face[axis] < 0) return found;
    int next = 0;
    lattice_.for_tets_of_face(face, axis, [&](const Tet& tet, std::size_t number) {
      if (next++ == edge) found.emplace(tet, number);
    });
    return found;
  }

  const TriangleTree& surface_;
  BccLattice lattice_;
  const Progress& progress_;
  std::vector<Side> side_, now_;                           // [point_count] as found, and after the warp
  std::vector<Cut> cuts_;                                  // between points inside and outside
  std::unordered_map<std::uint64_t, std::size_t> cut_of_;  // by the points of the edge
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> cuts_at_;
  std::vector<std::uint32_t> near_surface_;  // points with cuts, ascending
  std::unordered_map<std::uint32_t, Vector3d> moved_;
  std::unordered_map<std::size_t, Tet> kept_;                   // whole, by their number
  std::unordered_map<std::uint32_t, std::uint32_t> vertex_of_;  // of lattice points
  std::vector<std::uint8_t> rank_;                              // [vertices of the result]
  LatticeFill out_;
};

}  // namespace

LatticeFill fill_inside(const TriangleTree& surface, bool balanced, int cells, const Progress& progress) {
  return Filler(surface, balanced, cells, progress).fill();
}

}  // namespace fascia
