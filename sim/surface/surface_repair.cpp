#include "sim/surface/surface_repair.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "sim/mesh/vertex_check.h"
#include "sim/surface/surface_shells.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t kNoTriangle = ~0u;
constexpr std::size_t kFewestTriangles = 4;  // of a shell that encloses a volume
constexpr std::uint32_t kShellsBetweenReports = 64;
constexpr const char* kExamining = "Examining the surface";
constexpr std::size_t kSamples = 9;  // vertices of a shell that are tested for lying in another one

double area_of(const Vector3d& a, const Vector3d& b, const Vector3d& c) { return (b - a).cross(c - a).norm() / 2; }

class Repairer {
 public:
  /// Treatment of two triangles with the same vertices and opposite winding.
  enum class Opposites { keep_one, drop_both };

  Repairer(const SurfaceMesh& surface, Opposites opposites, const Progress& progress)
      : progress_(progress), opposites_(opposites), repaired_{surface.positions, {}, {}, {}, {}, false} {
    report_.vertices = surface.positions.size();
    report_.triangles = surface.triangles.size();
    report(progress_, 0, kExamining);
    collect(surface);
    report(progress_, 0.1, kExamining);
    connect();
    report(progress_, 0.2, kExamining);
    orient();
    find_holes();
    place_shells();
    repaired_.balanced = repaired_.closed() && is_balanced();
    if (repaired_.balanced && !crowded_.empty()) report_.volume = enclosed_volume();  // single shells are open
  }
  SurfaceRepair take() { return std::move(repaired_); }

 private:
  /// Triangles of welded vertices, without duplicates and those without area.
  void collect(const SurfaceMesh& surface) {
    const std::vector<std::uint32_t> first = first_at_place(x_);
    for (std::uint32_t v = 0; v < first.size(); ++v) report_.welded += first[v] != v;
    struct Entry {
      Triangle ascending, triangle;
      std::uint32_t index, source;
    };
    repaired_.turned.assign(surface.triangles.size(), 0);
    repaired_.left_out.assign(surface.triangles.size(), 1);
    std::uint32_t source = 0;
    std::vector<Entry> entries;
    entries.reserve(surface.triangles.size());
    for (const auto& [a, b, c] : surface.triangles) {
      const Triangle t{first[a], first[b], first[c]};
      const std::uint32_t own = source++;
      if (!(area_of(x_[t[0]], x_[t[1]], x_[t[2]]) > 0)) {
        report_.degenerate.add(x_[t[0]]);
        continue;
      }
      Triangle ascending = t;
      std::sort(ascending.begin(), ascending.end());
      entries.push_back({ascending, t, static_cast<std::uint32_t>(entries.size()), own});
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return a.ascending != b.ascending ? a.ascending < b.ascending : a.index < b.index;
    });
    enum Fate : char { stays, is_duplicate, is_wall };
    std::vector<Fate> fate(entries.size(), stays);
    for (std::size_t begin = 0, end; begin < entries.size(); begin = end) {
      int turns = 0;  // occurrences in one orientation minus those in the other
      for (end = begin; end < entries.size() && entries[end].ascending == entries[begin].ascending; ++end)
        turns += is_even(entries[end].triangle) ? 1 : -1;
      bool kept = opposites_ == Opposites::drop_both && turns == 0;
      for (std::size_t e = begin; e < end; ++e) {
        const bool right_way =
            opposites_ == Opposites::keep_one || turns == 0 || is_even(entries[e].triangle) == (turns > 0);
        if (!kept && right_way)
          kept = true;
        else
          fate[entries[e].index] =
              opposites_ == Opposites::drop_both && (turns == 0 || !right_way) ? is_wall : is_duplicate;
      }
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.index < b.index; });
    for (const Entry& entry : entries) {
      if (fate[entry.index] != stays) {
        (fate[entry.index] == is_wall ? report_.walls : report_.duplicates).add(x_[entry.triangle[0]]);
        continue;
      }
      triangles_.push_back(entry.triangle);
      source_.push_back(entry.source);
      repaired_.left_out[entry.source] = 0;
      for (const std::uint32_t v : entry.triangle) report_.box.extend(x_[v]);
    }
  }

  /// Whether the triangle has the orientation of its vertices in ascending order.
  static bool is_even(const Triangle& t) { return (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2; }

  /// Finds the neighbor across each edge of each triangle, for edges of exactly two.
  void connect() {
    struct Edge {
      std::uint32_t low, high, place;  // 3 * triangle + number of the edge, which leads from that corner to the next
    };
    std::vector<Edge> edges;
    edges.reserve(3 * triangles_.size());
    for (std::uint32_t place = 0; place < 3 * triangles_.size(); ++place) {
      const auto [from, to] = ends(place);
      edges.push_back({std::min(from, to), std::max(from, to), place});
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
      return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.place < b.place;
    });
    beyond_.assign(edges.size(), kNoTriangle);
    for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
      for (end = begin + 1;
           end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high;)
        ++end;
      const Vector3d middle = (x_[edges[begin].low] + x_[edges[begin].high]) / 2;
      if (end - begin == 1) {
        report_.open_edges.add(middle);
        open_.push_back({edges[begin].place / 3, edges[begin].low, edges[begin].high});
      } else if (end - begin == 2) {
        beyond_[edges[begin].place] = edges[begin + 1].place;
        beyond_[edges[begin + 1].place] = edges[begin].place;
      } else {
        report_.crowded_edges.add(middle);
        for (std::size_t e = begin; e < end; ++e) crowded_.push_back({edges[e].place / 3, edges[e].low, edges[e].high});
      }
    }
  }

  /// Numbers the shells and reverses the triangles that disagree with most of their shell.
  void orient() {
    shell_.assign(triangles_.size(), kNoTriangle);
    std::vector<char> turn(triangles_.size(), 0);
    std::vector<std::uint32_t> queue;
    for (std::uint32_t start = 0; start < triangles_.size(); ++start) {
      if (shell_[start] != kNoTriangle) continue;
      const auto number = static_cast<std::uint32_t>(report_.shells.size());
      report_.shells.emplace_back();
      queue.assign(1, start);
      shell_[start] = number;
      for (std::size_t i = 0; i < queue.size(); ++i) {
        const std::uint32_t t = queue[i];
        for (std::uint32_t place = 3 * t; place < 3 * t + 3; ++place) {
          if (beyond_[place] == kNoTriangle) continue;
          const std::uint32_t other = beyond_[place] / 3;
          const bool opposed = ends(place)[0] == ends(beyond_[place])[0];  // same direction along the edge
          const char wanted = static_cast<char>(turn[t] ^ static_cast<char>(opposed));
          if (shell_[other] == kNoTriangle) {
            shell_[other] = number;
            turn[other] = wanted;
            queue.push_back(other);
          } else if (turn[other] != wanted && t < other) {
            report_.one_sided.add(x_[ends(place)[0]]);
          }
        }
      }
      const std::size_t turned = static_cast<std::size_t>(
          std::count_if(queue.begin(), queue.end(), [&](std::uint32_t t) { return turn[t] != 0; }));
      const char less = 2 * turned <= queue.size();  // reversed ones are the minority
      std::sort(queue.begin(), queue.end());
      for (const std::uint32_t t : queue) {
        if (turn[t] != less) continue;
        report_.turned.add(x_[triangles_[t][0]]);
        turn_over(t);
      }
    }
  }

  /// Connected open edges form a hole; its area is that of the flat patch with the same area vector.
  void find_holes() {
    std::unordered_map<std::uint32_t, std::uint32_t> parent;
    const auto root = [&](std::uint32_t v) {
      while (parent.emplace(v, v).first->second != v) v = parent[v] = parent[parent[v]];
      return v;
    };
    for (const TriangleEdge& edge : open_) parent[root(edge.low)] = root(edge.high);
    std::unordered_map<std::uint32_t, Vector3d> area;
    const Vector3d origin = report_.box.isEmpty() ? Vector3d::Zero() : Vector3d(report_.box.center());
    for (const TriangleEdge& edge : open_) {
      const auto [entry, is_new] = area.emplace(root(edge.low), Vector3d::Zero());
      report_.holes += is_new;
      const Vector3d swept = (x_[edge.low] - origin).cross(x_[edge.high] - origin) / 2;
      entry->second += ascends(edge) ? swept : Vector3d(-swept);
    }
    std::vector<double> areas;
    for (const auto& [vertex, vector] : area) areas.push_back(vector.norm());
    std::sort(areas.begin(), areas.end());  // so that their sum does not depend on the table's order
    report_.hole_area = std::accumulate(areas.begin(), areas.end(), 0.0);
  }

  /// Computes volumes. An inverted shell is reversed, unless it lies in another one as its cavity. The volume of an
  /// open shell is that of the cone to its center, which is unknown for a flat one.
  void place_shells() {
    std::vector<SurfaceShell>& shells = report_.shells;
    constexpr double kFlat = 1e-6;  // volume for the area's 3/2 power
    std::vector<std::vector<Triangle>> parts(shells.size());
    std::vector<Eigen::AlignedBox3d> boxes(shells.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (const std::uint32_t v : triangles_[t]) boxes[shell_[t]].extend(x_[v]);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      SurfaceShell& shell = shells[shell_[t]];
      const auto& [a, b, c] = triangles_[t];
      const Vector3d origin = boxes[shell_[t]].center(), p = x_[a] - origin, q = x_[b] - origin, r = x_[c] - origin;
      ++shell.triangles;
      shell.area += area_of(p, q, r);
      shell.volume += p.cross(q).dot(r) / 6;
      parts[shell_[t]].push_back(triangles_[t]);
    }
    std::vector<TriangleTree> trees;  // of shells that may contain others
    std::vector<std::size_t> tree_of(shells.size(), shells.size());
    const auto holds = [&](std::size_t outer, std::size_t inner) {
      if (tree_of[outer] == shells.size()) {
        tree_of[outer] = trees.size();
        trees.push_back(tree_of_part(parts[outer]));
      }
      for (std::size_t s = 0; s < kSamples; ++s) {
        const Vector3d& p = x_[parts[inner][s * parts[inner].size() / kSamples][0]];
        if (std::abs(trees[tree_of[outer]].winding(p)) < 0.5) return false;
      }
      return true;
    };
    std::vector<ShellTree::Shell> holders;
    for (std::uint32_t s = 0; s < shells.size(); ++s)
      if (shells[s].triangles >= kFewestTriangles) holders.push_back({boxes[s], shells[s].area, s});
    const ShellTree tree(std::move(holders));
    std::vector<char> turn(shells.size(), 0);
    for (std::uint32_t s = 0; s < shells.size(); ++s) {
      if (s % kShellsBetweenReports == 0)
        report(progress_, 0.3 + 0.7 * s / static_cast<double>(shells.size()), kExamining);
      const std::uint32_t around =
          tree.largest_around(boxes[s], shells[s].area, [&](std::uint32_t outer) { return holds(outer, s); });
      const std::uint32_t outermost = around == ShellTree::kNone ? s : around;
      turn[s] = shells[outermost].volume < -kFlat * std::pow(shells[outermost].area, 1.5);
      shells[s].inverted = turn[s];
      shells[s].flat = std::abs(shells[s].volume) <= kFlat * std::pow(shells[s].area, 1.5);
      shells[s].cavity = outermost != s && (shells[s].volume < 0) != (shells[outermost].volume < 0);
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (turn[shell_[t]]) turn_over(t);
    for (SurfaceShell& shell : shells) {
      if (shell.inverted) shell.volume = -shell.volume;
      report_.area += shell.area;
      report_.volume += shell.volume;
    }
    std::stable_sort(shells.begin(), shells.end(),
                     [](const SurfaceShell& a, const SurfaceShell& b) { return a.area > b.area; });
  }

  /// Whether the edges of more than two triangles are traversed equally often in both directions.
  bool is_balanced() const {
    int sum = 0;
    for (std::size_t e = 0; e < crowded_.size(); ++e) {
      if (e > 0 && (crowded_[e].low != crowded_[e - 1].low || crowded_[e].high != crowded_[e - 1].high)) {
        if (sum != 0) return false;
      }
      sum += ascends(crowded_[e]) ? 1 : -1;
    }
    return sum == 0;
  }

  double enclosed_volume() const {
    const Vector3d origin = report_.box.center();
    double volume = 0;
    for (const auto& [a, b, c] : triangles_) volume += (x_[a] - origin).cross(x_[b] - origin).dot(x_[c] - origin) / 6;
    return volume;
  }

  void turn_over(std::size_t t) {
    std::swap(triangles_[t][1], triangles_[t][2]);
    repaired_.turned[source_[t]] ^= 1;
  }

  TriangleTree tree_of_part(std::vector<Triangle> part) const {
    std::unordered_map<std::uint32_t, std::uint32_t> number;
    std::vector<Vector3d> positions;
    for (Triangle& t : part) {
      for (std::uint32_t& v : t) {
        const auto [entry, is_new] = number.emplace(v, static_cast<std::uint32_t>(positions.size()));
        if (is_new) positions.push_back(x_[v]);
        v = entry->second;
      }
    }
    return {std::move(positions), std::move(part)};
  }

  struct TriangleEdge {
    std::uint32_t triangle, low, high;
  };
  /// Whether the triangle traverses its edge from the lower vertex to the higher one.
  bool ascends(const TriangleEdge& edge) const {
    const Triangle& t = triangles_[edge.triangle];
    return t[(std::find(t.begin(), t.end(), edge.low) - t.begin() + 1) % 3] == edge.high;
  }

  std::array<std::uint32_t, 2> ends(std::uint32_t place) const {
    const Triangle& t = triangles_[place / 3];
    return {t[place % 3], t[(place % 3 + 1) % 3]};
  }

  const Progress& progress_;
  const Opposites opposites_;
  SurfaceRepair repaired_;
  SurfaceReport& report_ = repaired_.report;
  std::vector<Vector3d>& x_ = repaired_.positions;
  std::vector<Triangle>& triangles_ = repaired_.triangles;
  std::vector<std::uint32_t> beyond_;         // [3 * triangle_count] index of the other triangle at each edge
  std::vector<std::uint32_t> shell_;          // [triangle_count]
  std::vector<std::uint32_t> source_;         // [triangle_count] index in the file
  std::vector<TriangleEdge> open_, crowded_;  // edges of one triangle, and of more than two
};

}  // namespace

void SurfaceFinding::add(const Vector3d& where) {
  if (count++ == 0) first = where;
}

SurfaceRepair repair(const SurfaceMesh& surface, const Progress& progress) {
  using Opposites = Repairer::Opposites;
  SurfaceRepair repaired = Repairer(surface, Opposites::keep_one, part_of(progress, 0, 0.5)).take();
  if (!repaired.closed() || repaired.balanced || repaired.report.duplicates.count == 0) return repaired;
  // Cells with all their faces: a face between two cells occurs twice, with opposite windings, and separates nothing.
  SurfaceRepair hull = Repairer(surface, Opposites::drop_both, part_of(progress, 0.5, 1)).take();
  return hull.balanced && hull.report.volume > 0 ? hull : repaired;
}

void put_right(SurfaceMesh& surface, const SurfaceRepair& repaired) {
  const bool colored = !surface.colors.empty();
  std::size_t kept = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (repaired.left_out[t]) continue;
    surface.triangles[kept] = surface.triangles[t];
    for (std::size_t k = 0; colored && k < 3; ++k) surface.colors[3 * kept + k] = surface.colors[3 * t + k];
    if (repaired.turned[t]) {
      std::swap(surface.triangles[kept][1], surface.triangles[kept][2]);
      if (colored) std::swap(surface.colors[3 * kept + 1], surface.colors[3 * kept + 2]);
    }
    ++kept;
  }
  surface.triangles.resize(kept);
  if (colored) surface.colors.resize(3 * kept);
  surface.closed = repaired.closed();
}

}  // namespace fascia
