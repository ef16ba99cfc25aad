#include "sim/contact/contact_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <limits>

#include "base/error.h"
#include "base/text.h"
#include "sim/contact/contact_block.h"
#include "sim/contact/tissue/penetration.h"
#include "sim/contact/tissue/tissue_surface.h"
#include "sim/tool/shape_distance.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

double longest_edge(const Model& model, const std::vector<Triangle>& triangles) {
  double longest = 0;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, (model.rest_positions[t[k]] - model.rest_positions[t[(k + 1) % 3]]).norm());
  return longest;
}

double mean_edge(const Model& model, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      sum += (model.rest_positions[t[k]] - model.rest_positions[t[(k + 1) % 3]]).norm();
  return sum / std::max(3.0 * static_cast<double>(triangles.size()), 1.0);
}

class PointList {
 public:
  PointList(const Model& model, std::vector<ContactPoint>& points) : held_(model.held()), points_(points) {}

  void add(std::array<std::uint32_t, 3> vertices, std::array<double, 3> weights, double area) {
    // A free vertex comes first: it carries the energy of the point.
    for (std::size_t k = 0; k < 3; ++k)
      if (weights[k] > 0 && !held_[vertices[k]]) {
        std::swap(vertices[0], vertices[k]);
        std::swap(weights[0], weights[k]);
        for (std::size_t unused = 1; unused < 3; ++unused)
          if (weights[unused] == 0) vertices[unused] = vertices[0];
        points_.push_back({vertices, weights, area});
        return;
      }
  }

 private:
  std::vector<char> held_;
  std::vector<ContactPoint>& points_;
};

void add_vertices(const Model& model, const std::vector<Triangle>& triangles, PointList& list) {
  const std::vector<double> area = tissue_areas(model, triangles);
  for (std::uint32_t v = 0; v < area.size(); ++v)
    if (area[v] > 0) list.add({v, v, v}, {1, 0, 0}, area[v]);
}

void add_level(int level, const Model& model, const std::vector<Triangle>& triangles,
               const std::vector<TissueEdge>& edges, PointList& list) {
  const int parts = 1 << level;
  for (const TissueEdge& e : edges)
    for (int i = 1; i < parts; i += 2) {
      const double share = static_cast<double>(i) / parts;
      list.add({e.from, e.to, e.from}, {1 - share, share, 0}, e.area);
    }
  for (const Triangle& t : triangles)
    for (int i = 1; i < parts; ++i)
      for (int j = 1; i + j < parts; ++j) {
        if (i % 2 == 0 && j % 2 == 0) continue;  // of a lower level
        list.add(t,
                 {static_cast<double>(i) / parts, static_cast<double>(j) / parts,
                  static_cast<double>(parts - i - j) / parts},
                 2 * area_of(model, t));
      }
}

std::string note_on(const Tool& tool, double spacing, double radius) {
  char text[160];
  std::snprintf(text, sizeof text, ": contact points are %.3g m apart, and parts of %.3g m may pass between them",
                spacing, radius);
  return tool.name + text;
}

/// Whether a path has a bend, as of a tool that is pressed in and slides on.
bool turns_off(const Tool& tool) {
  constexpr double kStraight = 0.01;  // sine of the angle
  Vector3d before(0, 0, 0);
  for (std::size_t k = 1; k < tool.path.size(); ++k) {
    const Vector3d way = tool.path[k].position - tool.path[k - 1].position;
    if (way.cross(before).norm() > kStraight * way.norm() * before.norm()) return true;
    if (!way.isZero(0)) before = way;
  }
  return false;
}

std::string note_on_edges(const Tool& tool, double round) {
  char text[160];
  std::snprintf(text, sizeof text,
                ": may hook into tissue with its sharp edges where it slides; a round of %.2g m helps", round);
  return tool.name + text;
}

std::string meters(double length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g m", length);
  return text;
}

/// [body] the mean edge of its surface [m]; 0 without one.
std::vector<double> mean_edges(const Model& model) {
  std::vector<double> sum(model.bodies.size(), 0), count(model.bodies.size(), 0);
  const std::vector<std::uint32_t> bodies = bodies_of_vertices(model);
  for (const Triangle& t : tissue_boundary(model))
    for (std::size_t k = 0; k < 3; ++k) {
      sum[bodies[t[k]]] += (model.rest_positions[t[k]] - model.rest_positions[t[(k + 1) % 3]]).norm();
      ++count[bodies[t[k]]];
    }
  for (std::size_t b = 0; b < sum.size(); ++b) sum[b] /= std::max(count[b], 1.0);
  return sum;
}

void check_thickness(const Model& model, const std::string& where, std::vector<std::string>& notes) {
  const double thickness = model.contact.thickness;
  if (thickness == 0 || model.bodies.empty()) return;
  const std::vector<double> edges = mean_edges(model);
  for (std::size_t b = 0; b < edges.size(); ++b) {
    const BodyPart& body = model.bodies[b];
    Eigen::AlignedBox3d box;
    for (std::uint32_t v = 0; v < body.vertex_count; ++v) box.extend(model.rest_positions[body.vertex_begin + v]);
    if (box.isEmpty()) continue;
    if (const double largest = box.sizes().maxCoeff(); thickness > largest)
      throw Error(where + ": contact.thickness",
                  "is " + meters(thickness) + ", more than the largest side of " + body.name + ", " + meters(largest),
                  "expected less than its elements, " + meters(edges[b]));
    const double half = 0.5 * box.sizes().minCoeff();
    if (thickness > half)
      notes.push_back("contact.thickness of " + meters(thickness) + " is more than half of the smallest side of " +
                      body.name + ", " + meters(half) + ": contact may crush it");
    else if (thickness > edges[b])
      notes.push_back("contact.thickness of " + meters(thickness) + " is more than the elements of " + body.name +
                      ", " + meters(edges[b]) + ": contact may crush them");
  }
}

std::string note_on(const Model& model, const Overlap& overlap) {
  const std::size_t count = overlap.vertices > 0 ? overlap.vertices : overlap.tets;
  return model.bodies[overlap.body].name + ": " + plural(count, overlap.vertices > 0 ? "vertex" : "tet") +
         (count == 1 ? " begins" : " begin") + " inside " + model.bodies[overlap.other].name + ", up to " +
         length(overlap.deepest) + " deep: contact pushes the bodies apart, or holds them in each other";
}

/// Bodies that begin inside the tool of a first piece, deeper than a hundredth of their size: less may be the load that
/// is meant.
void note_begun_inside(const Model& model, const ContactSurface& surface, const ContactPiece& piece,
                       std::vector<std::string>& notes) {
  constexpr double kShallow = 0.01;
  const Tool& tool = model.tools[piece.tool];
  std::vector<RigidPose> poses;
  for (std::size_t k = 0; k < tool.piece_count(); ++k) poses.push_back(tool.pose_of_piece(k, tool.place(0)));
  for (const BodyPart& body : model.bodies) {
    Eigen::AlignedBox3d box;
    std::size_t count = 0, inside = 0;
    double deepest = 0;
    for (std::uint32_t p = 0; p < piece.points; ++p) {
      const ContactPoint& point = surface.points[p];
      const std::uint32_t v = point.vertices[0];
      if (point.weights[0] != 1 || v < body.vertex_begin || v >= body.vertex_begin + body.vertex_count) continue;
      const Vector3d& x = model.rest_positions[v];
      double depth = -std::numeric_limits<double>::infinity();
      for (const RigidPose& pose : poses) depth = std::max(depth, -distance_to(tool.shape, pose.to_local(x)).distance);
      box.extend(x);
      ++count;
      inside += depth > 0;
      deepest = std::max(deepest, depth);
    }
    if (count == 0 || deepest <= kShallow * box.sizes().maxCoeff()) continue;
    notes.push_back(body.name + ": " + std::to_string(inside) + " of " + plural(count, "vertex") +
                    " of its surface begin inside " + tool.name + ", up to " + length(deepest) +
                    (inside == count ? " deep: is " + tool.name + " as large as it should be, and in its place?"
                                     : " deep: contact pushes them out within a step"));
  }
}

bool is_in(const Tet& tet, const std::vector<Vector3d>& x, const Vector3d& point) {
  const double whole = signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]);
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<Vector3d, 4> corners = {x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]};
    corners[k] = point;
    if (signed_volume6(corners[0], corners[1], corners[2], corners[3]) * whole < 0) return false;
  }
  return true;
}

constexpr double kDeep = 0.25;  // of a finest part

/// Whether a piece is inside of the tissue as the scene begins, and so deep that no contact point touches it.
bool begins_inside(const Model& model, const ContactSurface& surface, const ContactPiece& piece) {
  const Tool& tool = model.tools[piece.tool];
  if (std::holds_alternative<PlaneShape>(tool.shape)) return false;
  const RigidPose pose = tool.pose_of_piece(piece.piece, tool.place(0));
  const std::vector<Vector3d>& x = model.rest_positions;
  const Vector3d middle = pose.to_scene(middle_of(tool.shape));
  const auto holds = [&](const Tet& tet) { return is_in(tet, x, middle); };
  if (std::none_of(model.tets.begin(), model.tets.end(), holds)) return false;
  return std::none_of(surface.points.begin(), surface.points.begin() + piece.points, [&](const ContactPoint& point) {
    return distance_to(tool.shape, pose.to_local(point.at(x))).distance <= 0.5 * model.contact.thickness;
  });
}

}  // namespace

double depth_in_tissue(const Model& model, const ContactSurface& surface, const std::vector<Vector3d>& u,
                       std::size_t tool, const ToolPlace& place) {
  const ToolShape& shape = model.tools[tool].shape;
  if (std::holds_alternative<PlaneShape>(shape)) return 0;
  std::vector<Vector3d> x = model.rest_positions;
  for (std::size_t v = 0; v < x.size(); ++v) x[v] += u[v];
  const double deep = kDeep * surface.finest_parts[tool];
  double depth = 0;
  for (const ContactPiece& piece : surface.pieces) {
    if (piece.tool != tool) continue;
    const RigidPose pose = model.tools[tool].pose_of_piece(piece.piece, place);
    const Vector3d middle = pose.to_scene(middle_of(shape));
    if (std::any_of(model.tets.begin(), model.tets.end(), [&](const Tet& tet) { return is_in(tet, x, middle); }))
      return 1;
    for (std::uint32_t p = 0; p < piece.points; ++p)
      depth = std::max(depth, -distance_to(shape, pose.to_local(surface.points[p].at(x))).distance);
  }
  return depth / deep;
}

std::vector<std::string> check_contact(const Model& model, const std::string& where) {
  const ContactSurface surface = make_contact_surface(model);
  if (surface.pieces.size() > ContactSurface::kMostPieces)
    throw Error(where + ": contact", "has " + std::to_string(surface.pieces.size()) + " rigid pieces",
                "expected at most " + std::to_string(ContactSurface::kMostPieces) +
                    ": ground, obstacles, instruments, jaws as two");
  std::vector<std::string> notes = surface.notes;
  check_thickness(model, where, notes);
  if (model.contact.bodies)
    for (const Overlap& overlap : overlaps_at_rest(model)) notes.push_back(note_on(model, overlap));
  for (const ContactPiece& piece : surface.pieces)
    if (piece.piece == 0) note_begun_inside(model, surface, piece, notes);
  for (const ContactPiece& piece : surface.pieces)
    if (piece.piece == 0 && begins_inside(model, surface, piece))
      notes.push_back(model.tools[piece.tool].name +
                      ": begins wholly inside tissue, and touches nothing until the surface reaches it");
  return notes;
}

ContactSurface make_contact_surface(const Model& model) {
  // Of the longest edge: a quarter of what points near sharp edges are apart, and half of that. Without it, rounding
  // says which points of a flat face bear first.
  constexpr double kResolved = 1.0 / 16, kFirstReach = 1.0 / 32;
  ContactSurface surface;
  if (model.tools.empty()) return surface;
  const std::vector<Triangle> triangles = tissue_boundary(model);
  const double longest = longest_edge(model, triangles);
  surface.full_slip = kFullSlip * mean_edge(model, triangles);
  surface.edge_width = longest;
  surface.first_reach = longest * kFirstReach;
  const auto level_for = [&](double radius, int finest) {
    int level = 0;
    while (level < finest && longest / (1 << level) > radius / 2) ++level;
    return level;
  };
  std::vector<int> levels, edge_levels;
  int finest = 0;
  for (const Tool& tool : model.tools) {
    const double radius = finest_radius(tool.shape);
    const int level = levels.emplace_back(level_for(radius, ContactSurface::kFinestLevel));
    const double spacing = longest / (1 << level);
    if (spacing > 2 * radius) surface.notes.push_back(note_on(tool, spacing, radius));
    if (sharpest_edge(tool.shape) < longest * kResolved && turns_off(tool))
      surface.notes.push_back(note_on_edges(tool, std::min(2 * kResolved * longest, radius)));
    surface.finest_parts.push_back(std::min(radius, std::max(sharpest_edge(tool.shape), longest * kResolved)));
    const int of_edges = level_for(sharpest_edge(tool.shape), ContactSurface::kFinestLevelOfEdges);
    finest = std::max(finest, edge_levels.emplace_back(std::max(level, of_edges)));
  }
  const std::vector<TissueEdge> edges = finest > 0 ? tissue_edges(model, triangles) : std::vector<TissueEdge>();
  PointList list(model, surface.points);
  std::array<std::uint32_t, ContactSurface::kFinestLevel + 1> count{};
  for (int level = 0; level <= finest; ++level) {
    if (level == 0)
      add_vertices(model, triangles, list);
    else
      add_level(level, model, triangles, edges, list);
    count[static_cast<std::size_t>(level)] = static_cast<std::uint32_t>(surface.points.size());
  }
  for (std::uint32_t t = 0; t < model.tools.size(); ++t)
    for (std::uint32_t piece = 0; piece < model.tools[t].piece_count(); ++piece) {
      const std::uint32_t everywhere = count[static_cast<std::size_t>(levels[t])],
                          points = count[static_cast<std::size_t>(edge_levels[t])];
      surface.pieces.push_back({t, piece, edge_levels[t], points, everywhere, surface.row_count});
      surface.row_count += points;
    }
  return surface;
}

bool has_row(const ContactSurface& surface, const ContactPiece& piece, std::uint32_t point, const ToolShape& shape,
             const Vector3d& x, const RigidPose& from, const RigidPose& to, double before) {
  return point < piece.everywhere || before > 0 || near_edge(shape, from.to_local(x), surface.edge_width) ||
         near_edge(shape, to.to_local(x), surface.edge_width);
}

std::vector<double> contact_stiffness(const Model& model, const ContactSurface& surface) {
  const std::vector<double> below = tissue_stiffness(model, tissue_areas(model, tissue_boundary(model)));
  std::vector<double> stiffness;
  stiffness.reserve(surface.points.size());
  for (const ContactPoint& point : surface.points) {
    double per_area = 0;  // [Pa/m]
    for (std::size_t k = 0; k < 3; ++k)
      if (point.weights[k] > 0) per_area += point.weights[k] * below[point.vertices[k]];
    stiffness.push_back(kContactPenalty * model.contact.stiffness * per_area * point.area);
  }
  return stiffness;
}

std::vector<double> stage_stiffness(const Model& model, const ContactSurface& surface,
                                    const std::vector<double>& stiffness, double length) {
  const std::vector<double> masses = lumped_masses(model), viscosity = tissue_viscosity(model);
  std::vector<double> in_stage;
  in_stage.reserve(surface.points.size());
  for (std::size_t p = 0; p < surface.points.size(); ++p) {
    const ContactPoint& point = surface.points[p];
    double mass = 0, ratio = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      mass += point.weights[k] * masses[point.vertices[k]];
      ratio += point.weights[k] * viscosity[point.vertices[k]];
    }
    const double damping = ratio * stiffness[p] / (kContactPenalty * model.contact.stiffness);
    in_stage.push_back(stage_stiffness(stiffness[p], mass, damping, length));
  }
  return in_stage;
}

void soften(ContactMemory& memory, const ContactSurface& surface, const std::vector<double>& before,
            const std::vector<double>& after) {
  if (memory.size() < surface.row_count) return;
  for (const ContactPiece& piece : surface.pieces)
    for (std::uint32_t p = 0; p < piece.points; ++p)
      if (after[p] < before[p]) soften(memory[piece.first_row + p], after[p] / before[p]);
}

}  // namespace fascia
