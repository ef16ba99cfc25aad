#include "sim/bare_mesh/plan.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "base/file.h"
#include "base/text.h"
#include "sim/bare_mesh/flat_sides.h"
#include "sim/bare_mesh/foot.h"
#include "sim/bare_mesh/stiffness.h"
#include "sim/material/tissues.h"
#include "sim/mesh/pieces.h"
#include "sim/model/vertex_selection.h"

namespace fascia {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kEarth = 9.81;  // [m/s^2]
constexpr double kLargest = 3;   // [m] of a body in meters
// Shares of flat sides: a side as a whole; the flank of a lying cylinder; the feet of a table.
constexpr double kTruly = 0.5, kHalfway = 0.1, kFeet = 0.02;
constexpr double kSameArea = 1.05;  // ratio of areas up to which the more usual axis is taken
constexpr double kWide = 0.3;       // stability on feet
constexpr double kStable = 0.15;    // stability of what stands: a box 6.7 times as high as wide
constexpr double kFirm = 0.2;       // stability above which more support changes little
constexpr double kSlender = 3;      // ratio of extents above which a body without flat sides lies down
constexpr std::array kShares = {0.02, 0.05, 0.1, 0.15, 0.2, 0.3};
constexpr double kSmallPiece = 0.01;  // of the vertices

std::string percent(double share) {
  char text[16];
  std::snprintf(text, sizeof text, "%.2g %%", 100 * share);
  return text;
}

/// The largest extent of the mesh in its own coordinates decides.
void choose_unit(double extent, bool open, BareMeshPlan& plan) {
  if (open) plan.unit = likely_unit(extent);
  const std::string size =
      plan.unit == LengthUnit::m && extent < 0.01 ? length(extent) : number(extent) + " " + name_of(plan.unit);
  plan.unit_reason = size + " wide" + (open ? "" : ", as given");
}

/// The axis that points up in most files of a kind: modelers of surfaces write y, medical images and engineering z.
UpAxis usual_up(const std::filesystem::path& file, LengthUnit unit) {
  const std::string ending = lower_ending(file);
  if (ending == ".obj" || ending == ".ply" || ending == ".off") return UpAxis::y;
  return ending == ".stl" || unit != LengthUnit::m ? UpAxis::z : UpAxis::y;
}

struct Stance {
  UpAxis up;
  enum class Hold { foot, top, underside } hold;
  std::string reason;
  double depth = 0;  // FlatSide::depth
};
using Hold = Stance::Hold;

class StanceChoice {
 public:
  StanceChoice(const FlatSides& sides, UpAxis usual) : sides_(sides), usual_(static_cast<std::size_t>(usual)) {}

  Stance choose() const {
    if (stands(usual_, kTruly) || stands_wide(usual_)) return standing(usual_);
    if (hangs(usual_)) return hanging(usual_);
    if (const auto axis = best(kTruly)) return stands(*axis, kFeet) ? standing(*axis) : turned_over(*axis);
    if (stands(usual_, kHalfway)) return standing(usual_);
    if (const auto axis = best(kHalfway); axis && stands(*axis, kHalfway)) return standing(*axis);
    if (const auto axis = widest()) return standing(*axis);
    return resting();
  }
  /// With an axis that is stated: held by the side that a guess of it would hold.
  Stance choose(UpAxis up) const {
    const auto axis = static_cast<std::size_t>(up) % 3;
    const bool turned = static_cast<std::size_t>(up) >= 3;
    const FlatSide &low = turned ? sides_.high[axis] : sides_.low[axis],
                   &high = turned ? sides_.low[axis] : sides_.high[axis];
    if (stands(low, kTruly) || stands_wide(low)) return {up, Hold::foot, "", low.depth};
    if (hangs(low, high)) return {up, Hold::top, "", high.depth};
    if (stands(low, kHalfway)) return {up, Hold::foot, "", low.depth};
    return {up, Hold::underside, ""};
  }

 private:
  static bool stands(const FlatSide& low, double share) { return low.share >= share && low.stability >= kStable; }
  bool stands(std::size_t axis, double share) const { return stands(sides_.low[axis], share); }
  /// On legs that are far apart.
  static bool stands_wide(const FlatSide& low) { return low.share >= kFeet && low.stability >= kWide; }
  bool stands_wide(std::size_t axis) const { return stands_wide(sides_.low[axis]); }
  /// Flat at the top, with nothing below to stand on.
  static bool hangs(const FlatSide& low, const FlatSide& high) {
    return high.share >= kTruly && low.share < kTruly && !stands(low, kFeet);
  }
  bool hangs(std::size_t axis) const { return hangs(sides_.low[axis], sides_.high[axis]); }

  /// The axis with the largest flat side on which the mesh stands, or on which it would stand turned over.
  std::optional<std::size_t> best(double share) const {
    std::optional<std::size_t> found;
    double largest = 0;
    for (const std::size_t axis : {std::size_t{1}, std::size_t{2}, std::size_t{0}}) {
      const FlatSide& high = sides_.high[axis];
      const double area = std::max(stands(axis, share) ? sides_.low[axis].area : 0,
                                   high.share >= share && high.stability >= kStable ? high.area : 0);
      if (area <= kSameArea * largest) continue;
      largest = area;
      found = axis;
    }
    return found;
  }

  /// The axis with the widest legs or rim on which the mesh stands, as a ring does that lies.
  std::optional<std::size_t> widest() const {
    std::optional<std::size_t> found;
    for (const std::size_t axis : {std::size_t{1}, std::size_t{2}, std::size_t{0}})
      if (stands_wide(axis) && (!found || sides_.low[axis].stability > sides_.low[*found].stability)) found = axis;
    return found;
  }

  Stance standing(std::size_t axis) const {
    return {kUpAxes[axis], Hold::foot, "stands on its flat side", sides_.low[axis].depth};
  }
  Stance hanging(std::size_t axis) const {
    return {kUpAxes[axis], Hold::top, "flat at its top", sides_.high[axis].depth};
  }
  /// y and z often point up, so that a flat side at their upper end is the top.
  Stance turned_over(std::size_t axis) const {
    if (kUpAxes[axis] != UpAxis::x) return hanging(axis);
    return {UpAxis::minus_x, Hold::foot, "stands on its flat side", sides_.high[axis].depth};
  }
  Stance resting() const {
    const Vector3d& size = sides_.size;
    const double across = std::max(size[static_cast<int>((usual_ + 1) % 3)], size[static_cast<int>((usual_ + 2) % 3)]);
    if (size[static_cast<int>(usual_)] <= kSlender * across)
      return {kUpAxes[usual_], Hold::underside, "usual in such files, no flat side"};
    return {usual_ == 1 ? UpAxis::z : UpAxis::y, Hold::underside, "slender, lies down"};
  }

  const FlatSides& sides_;
  std::size_t usual_;
};

/// Names of groups that are meant as supports.
bool means_support(std::string name) {
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::array words = {"fixed", "clamp", "support", "encastre", "dirichlet", "anchor"};
  return std::any_of(words.begin(), words.end(), [&](const char* word) { return name.starts_with(word); });
}

/// The share of the lowest part on which a piece stands firmly, or as firmly as on its lowest third. `points`: x, z as
/// seen from above, and the height.
double lowest_share(std::vector<Vector3d> points, const Vector3d& center) {
  std::sort(points.begin(), points.end(), [](const Vector3d& a, const Vector3d& b) { return a.y() < b.y(); });
  const double bottom = points.front().y(), height = points.back().y() - bottom;
  const auto stability_of = [&](double share) {
    std::vector<Vector2d> contact;
    const auto least = static_cast<std::size_t>(share * static_cast<double>(points.size()));
    for (const Vector3d& p : points)
      if (p.y() <= bottom + share * height || contact.size() < least) contact.emplace_back(p.z(), p.x());
    return stability(std::move(contact), {center.z(), center.x()}, std::max(center.y() - bottom, 1e-9 * height));
  };
  const double enough = std::min(kFirm, 0.9 * stability_of(kShares.back()));
  for (const double share : kShares)
    if (const double reached = stability_of(share); reached >= enough && reached > 0) return share;
  return kShares.back();
}

class SupportChoice {
 public:
  SupportChoice(const TetMesh& mesh, const std::vector<Tet>& tets, const Body& placed) : mesh_(mesh), tets_(tets) {
    const Eigen::Affine3d place = placement(placed);
    for (const Vector3d& p : mesh.positions) positions_.push_back(place * p);
  }

  /// `depth`: FlatSide::depth of the side that is held.
  void choose(Hold hold, double depth, BareMeshPlan& plan) const {
    for (const auto& [name, vertices] : mesh_.groups)
      if (means_support(name) && 2 * vertices.size() < mesh_.positions.size())
        plan.fixed.emplace_back(GroupSelection{name});
    if (!plan.fixed.empty()) {
      plan.support_reason = plan.fixed.size() == 1
                                ? "held by the group " + std::get<GroupSelection>(plan.fixed[0]).group
                                : "held by " + std::to_string(plan.fixed.size()) + " groups";
      return;
    }
    const std::vector<std::uint32_t> piece = pieces_of(tets_, positions_.size());
    std::map<std::uint32_t, std::vector<Tet>> pieces;
    for (const Tet& t : tets_) pieces[piece[t[0]]].push_back(t);
    const double share = hold == Hold::underside ? share_of(pieces) : kShares.front() + depth;
    const bool hangs = hold == Hold::top;
    plan.fixed.emplace_back(LowestSelection{share, hangs, pieces.size() > 1});
    plan.support_reason = std::string("held at ") + (hangs ? "the highest " : "the lowest ") + percent(share) +
                          (pieces.size() > 1 ? " of each of its " + plural(pieces.size(), "piece") : "");
  }

  const std::vector<Vector3d>& positions() const { return positions_; }

 private:
  double share_of(const std::map<std::uint32_t, std::vector<Tet>>& pieces) const {
    double share = kShares.front();
    for (const auto& [number, tets] : pieces) {
      if (static_cast<double>(tets.size()) < kSmallPiece * static_cast<double>(tets_.size())) continue;
      std::vector<Vector3d> points;
      const std::vector<char> used = used_vertices(tets, positions_.size());
      for (std::size_t v = 0; v < used.size(); ++v)
        if (used[v]) points.push_back(positions_[v]);
      share = std::max(share, lowest_share(std::move(points), bulk_of(positions_, tets).center));
    }
    return share;
  }

  const TetMesh& mesh_;
  const std::vector<Tet>& tets_;
  std::vector<Vector3d> positions_;  // placed
};

std::vector<std::uint32_t> held_vertices(const TetMesh& mesh, const std::vector<Tet>& tets, const Body& body) {
  std::vector<std::uint32_t> held;
  for (const Selection& selection : body.fixed) {
    const auto vertices = select_vertices(selection, {mesh, tets, body.up}, "fixed");
    held.insert(held.end(), vertices.begin(), vertices.end());
  }
  std::sort(held.begin(), held.end());
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
}

/// Whether three of the vertices are not on a line.
bool keep_from_turning(const std::vector<Vector3d>& x, const std::vector<std::uint32_t>& held) {
  const auto away = [&](std::uint32_t v) { return (x[v] - x[held[0]]).norm(); };
  const std::uint32_t far =
      *std::max_element(held.begin(), held.end(), [&](auto a, auto b) { return away(a) < away(b); });
  const Vector3d line = x[far] - x[held[0]];
  return std::any_of(held.begin(), held.end(),
                     [&](std::uint32_t v) { return line.cross(x[v] - x[held[0]]).norm() > 1e-6 * line.squaredNorm(); });
}

std::string pascals(double value) {
  constexpr std::array<std::pair<double, const char*>, 4> units = {
      {{1e9, " GPa"}, {1e6, " MPa"}, {1e3, " kPa"}, {1, " Pa"}}};
  for (const auto& [scale, name] : units)
    if (value >= scale) return number(value / scale) + name;
  return number(value) + " Pa";
}

}  // namespace

LengthUnit likely_unit(double extent) {
  for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::um})
    if (extent > kLargest && extent * meters(unit) <= kLargest) return unit;
  return LengthUnit::m;
}

BareMeshPlan plan_bare_mesh(const std::filesystem::path& file, const TetMesh& mesh, const std::vector<Tet>& tets,
                            const Unsettled& open, const Body& body, double gravity, double extent) {
  BareMeshPlan plan;
  plan.overrides = open.overrides;
  plan.unit = body.unit;
  plan.up = body.up;
  plan.fixed = body.fixed;
  plan.young_modulus = body.material.young_modulus;
  plan.law = open.law ? kTissueLaw : body.material.model;
  const FlatSides sides = flat_sides(mesh.positions, tets);
  choose_unit((extent > 0 ? extent : sides.size.maxCoeff()) * body.transform.scale, open.unit, plan);
  const StanceChoice choice(sides, usual_up(file, plan.unit));
  const Stance stance = open.up ? choice.choose() : choice.choose(body.up);
  plan.up = stance.up;
  plan.up_reason = open.up ? stance.reason : "as given";
  Body placed = body;
  placed.unit = plan.unit;
  placed.up = plan.up;
  const SupportChoice support(mesh, tets, placed);
  if (open.supports)
    support.choose(stance.hold, stance.depth, plan);
  else
    plan.support_reason = body.fixed.empty() && body.prescribed.empty() ? "free as given" : "held as given";
  placed.fixed = plan.fixed;
  if (!open.stiffness) {
    plan.stiffness_reason = "as given";
    return plan;
  }
  std::vector<std::uint32_t> held = held_vertices(mesh, tets, placed);
  if (!held.empty() && !keep_from_turning(support.positions(), held)) {
    plan.stiffness_reason = "not guessed: held at " + plural(held.size(), "point") + ", it can turn";
    return plan;
  }
  const WeightResponse response =
      weight_response({support.positions(), tets, std::move(held)}, body.material, gravity > 0 ? gravity : kEarth);
  plan.young_modulus = modulus_for(response);
  plan.stiffness_reason = "its weight strains it by " + percent(response.strain / plan.young_modulus);
  return plan;
}

std::string text_of(const BareMeshPlan& plan) {
  return std::string("taken as ") + name_of(plan.unit) + " (" + plan.unit_reason + "), " + name_of(plan.up) + " up (" +
         plan.up_reason + "), " + plan.support_reason + ", E " + pascals(plan.young_modulus) + " (" +
         plan.stiffness_reason + "); --unit, --up and --set change it";
}

}  // namespace fascia
