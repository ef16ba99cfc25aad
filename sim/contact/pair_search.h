// Finds where tissue may touch tissue in a step: other bodies, and itself.
//
// Bodies are solid, so that the sides of a surface are known: a vertex in front of a face has a positive gap along the
// face's outward normal, one behind it a negative one, and both are pressed to the same place. Convex edges that cross
// are the other kind of contact. Which pairs are possible is what the normals say (the Gauss maps of two surfaces that
// touch meet: Gottschalk 2000): a vertex and a face whose outward normals oppose each other, two edges whose arcs of
// normals cross. Gap, normal and weights are those of the moment within the step at which the pair would touch if all
// vertices moved on straight; they stay constant within the step, which so has one smooth energy.
//
// Each vertex remembers a force for every other body (up to kBodySlots), and each edge for two other edges: pairs that
// slide along a surface keep their force. Of several pairs for one slot the nearest is taken, and of several that are
// almost equally near the one that pressed in the step before. Without that, two pairs take the slot in turn: each is
// pressed out while it holds the slot, and starts without a force, friction above all, in every other step.
//
// Normals say little where tissue is creased. What a solution of the step leads through each other all the same is
// found by continuous collision detection and guarded: a pair with the normal that it went through by, whatever the
// normals of its sides, in slots of its own.
#pragma once
#include <algorithm>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/contact/pair_row.h"
#include "sim/contact/tissue/box_tree.h"
#include "sim/contact/tissue/penetration.h"
#include "sim/contact/tissue/tissue_surface.h"
#include "sim/model/state.h"

namespace fascia {

class PairSearch {
 public:
  static constexpr std::uint32_t kBodySlots = 4;
  static constexpr std::uint32_t kEdgeSlots = 2;

  /// Empty if no tissue of the model touches tissue.
  explicit PairSearch(const Model& model);
  /// Forces in `memory` [row_count()] fall with the stiffness of their pairs, as those of tools do (soften()).
  void materials_changed(const Model& model, std::span<ContactForce> memory = {});

  bool empty() const { return slot_count_ == 0; }
  std::uint32_t slot_count() const { return slot_count_; }
  std::uint32_t row_count() const { return memory_rows(slot_count_); }  // of the memory (sim/contact/pair_row.h)
  bool sees_near() const { return std::find(near_.begin(), near_.end(), 1) != near_.end(); }  // after find()
  double skin() const { return skin_; }  // [m] the gap that is left between surfaces

  /// [vertex_count] whether the vertex's body pressed another one in the step before, or is set on one as the scene
  /// begins, at `time` 0 [s]. Contact carries such a body: where gravity alone would lead it, edges would meet what
  /// they slide over.
  std::vector<char> carried(std::span<const ContactForce> before, double time) const;
  /// The pairs of a step, by ascending slot. `start` and `end`: displacements [vertex_count] at the start, and where
  /// velocities lead [m]; `before` [row_count]: the memory that the step before left; `length`: of the stage [s];
  /// `time`: at its start [s].
  std::vector<PairRow> find(const std::vector<Eigen::Vector3d>& start, const std::vector<Eigen::Vector3d>& end,
                            std::span<const ContactForce> before,
                            double length = std::numeric_limits<double>::infinity(),
                            double time = std::numeric_limits<double>::infinity());

  /// After find(), with the result of its step: whether the step must be solved again, since an edge of the surface
  /// goes through a triangle that it did not go through at the start, a pair was pressed in by most of the skin, or
  /// the normal of a vertex at an edge stopped what slides around it.
  /// `end` [vertex_count] [m].
  bool misses(const std::vector<Eigen::Vector3d>& end);
  /// After misses(): the pairs on the way to that result, and those that keep apart what it led through each other.
  /// Their forces of the step before (PairRow::before) are raised where they were too weak.
  std::vector<PairRow> find_again();
  static constexpr int kMostSearches = 12;
  /// Whether something went through in the result that misses() looked at last.
  bool cuts() const { return cuts_; }
  /// After the last search: the displacements [vertex_count] [m] of a step from `start` whose solution `end` still
  /// leads tissue through tissue. The bodies that meet so go only as far of their own ways as nothing goes through, and
  /// for the rest as one rigid body with their momentum and angular momentum where nothing holds them. Nothing: it does
  /// not. `masses` [vertex_count] [kg].
  std::optional<std::vector<Eigen::Vector3d>> taken_back(const std::vector<Eigen::Vector3d>& start,
                                                         const std::vector<Eigen::Vector3d>& end,
                                                         const std::vector<double>& masses);
  /// Velocities [vertex_count] [m/s] of a stage of `duration` [s] that is taken back, as the one before it was: those
  /// of the ways that are left. Once, bodies keep the velocities that the forces of the solution have led to, and come
  /// to meet a little later; where they stand still in stage after stage, these forces would add up.
  static void slow_down(const std::vector<Eigen::Vector3d>& start, const std::vector<Eigen::Vector3d>& end,
                        const std::vector<Eigen::Vector3d>& back, double duration,
                        std::vector<Eigen::Vector3d>& velocity);
  /// Both for the state at the end of a stage; whether it was taken back.
  bool take_back(const std::vector<Eigen::Vector3d>& start, const std::vector<double>& masses, double duration,
                 State& state);

 private:
  struct Together;
  std::vector<Together> together(const std::vector<std::uint32_t>& leaders, const std::vector<Eigen::Vector3d>& start,
                                 const std::vector<Eigen::Vector3d>& end, const std::vector<double>& masses) const;
  static constexpr std::uint32_t kNone = ~0u;
  struct Candidate {
    PairRow row;
    double distance = 0;                  // by which the pairs of a slot are compared: the least one takes it [m]
    std::uint32_t first = 0, second = 0;  // of two edges
    std::uint32_t kept = kNone;           // the slot that remembers these two
  };
  static constexpr double kMargin = 0.25;  // of the mean edge: pairs this much farther than the skin may touch by what
                                           // forces do in the step
  static constexpr double kGrazed = 0.5;   // of the skin: by what is this near, edges do not slide
  struct Crossing {
    double s = 0, t = 0;  // shares of the way along the two edges
  };
  struct Beside {
    Eigen::Vector3d weights{0, 0, 0};  // of the corners of a face, of its point next to a vertex
    Eigen::Vector3d normal{0, 0, 0};   // from there to the vertex
    double distance = 0;               // [m]
  };
  std::optional<Beside> approach_beside(std::uint32_t vertex, const Triangle& triangle) const;
  enum class Facing { face, edge, other_face };  // what a vertex beside a face is opposite to
  Facing facing_of(const Beside& beside, std::uint32_t triangle) const;
  /// The nearest points of two lines that are not parallel.
  static std::optional<Crossing> crossing_of(const Eigen::Vector3d& a, const Eigen::Vector3d& along_a,
                                             const Eigen::Vector3d& b, const Eigen::Vector3d& along_b);
  std::vector<PairRow> find_pairs();
  void find_set_on_each_other(const Model& model);
  double stage_stiffness_of(const PairRow& row) const;          // [N/m]
  double skin_between(std::uint32_t a, std::uint32_t b) const;  // of two bodies [m]
  double target_of(const PairRow& row, double gap) const;  // the gap at the end of the stage, if the pair presses [m]
  double softness_of(const PairRow& row) const;            // of both sides in a row [m/Pa]
  /// Of the two sides of a pair [m/Pa]. A guard does not know what it met (PairRow::met 0): twice that of its slot.
  double softness_between(const std::vector<double>& softness, std::uint32_t slot, double met) const;
  void keep_guards();
  void keep_guard_of_vertex(std::uint32_t vertex);
  void keep_guard_of_edge(std::uint32_t edge);
  void add_guards();
  bool guard(std::uint32_t edge, std::uint32_t triangle);
  bool add_guard(const Passage& passage, const std::array<std::uint32_t, 4>& vertices, const PairRow::Sides& sides,
                 double area, std::initializer_list<std::uint32_t> slots);
  bool press_harder(const PairRow& row);
  double depth_of(const PairRow& row) const;  // at end_ [m]
  bool turned(const PairRow& row) const;
  bool began_inside(const TissueEdge& edge, std::uint32_t body) const;
  std::array<Eigen::Vector3d, 3> at_start(const Triangle& t) const {
    return {start_[t[0]], start_[t[1]], start_[t[2]]};
  }
  bool all_held(const std::array<std::uint32_t, 4>& vertices) const;
  std::uint32_t guard_of_vertex(std::uint32_t vertex) const;
  std::uint32_t guard_of_edge(std::uint32_t edge) const {
    return first_guard_ + static_cast<std::uint32_t>(vertices_.size()) + edge;
  }
  void look_at(const std::vector<Eigen::Vector3d>& end);
  /// Calls found(edge, triangle) for what goes through at end_ and did not at start_.
  template <class F>
  void for_new_cuts(F&& found) const;
  template <class F>
  void for_cuts(std::uint32_t edge, std::uint32_t body, const std::vector<Eigen::Vector3d>& x, F&& found) const;
  void place();  // what follows from start_ and end_
  void offer(const Candidate& candidate);
  void choose_crossings();
  void look_at_vertex(std::size_t index, std::uint32_t body);
  void look_at_edge(std::uint32_t edge, std::uint32_t body);
  void try_vertex(std::uint32_t vertex, std::size_t index, std::uint32_t triangle);
  void try_edges(std::uint32_t first, std::uint32_t second);
  bool may_touch(std::uint32_t a, std::uint32_t b) const { return a == b ? self_ : bodies_; }
  Eigen::Vector3d along(const TissueEdge& edge) const;
  std::uint32_t first_slot_of_edge(std::uint32_t edge) const {
    return static_cast<std::uint32_t>(vertices_.size()) * body_slots_ + edge * kEdgeSlots;
  }
  bool edge_pressed(std::uint32_t edge) const {
    const auto first = pressed_.begin() + first_slot_of_edge(edge);
    return std::find(first, first + kEdgeSlots, 1) != first + kEdgeSlots;
  }
  bool remembers(std::uint32_t slot, std::uint32_t feature) const {
    return pressed_[slot] && met_[slot] == feature + 1;
  }
  void see_near(std::initializer_list<std::uint32_t> vertices) {
    for (const std::uint32_t v : vertices) near_[v] = 1;
  }
  void fit_trees(const std::vector<Eigen::AlignedBox3d>& boxes, const std::vector<Eigen::AlignedBox3d>& facings);
  std::vector<Eigen::AlignedBox3d> facings() const;  // [triangle]
  Eigen::Vector3d normal_sum(const TissueEdge& edge) const { return normals_[edge.sides[0]] + normals_[edge.sides[1]]; }
  double way_of(std::uint32_t v) const { return (end_[v] - start_[v]).norm(); }

  bool self_ = false, bodies_ = false;
  double skin_ = 0, edge_ = 0;  // [m]; edge: the mean length of edges
  double penalty_ = 0, length_ = 0, time_ = 0;
  // By bodies, the lower one first: the least gap at first [m]
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> set_on_each_other_;
  std::vector<double> masses_;                                       // [vertex_count] [kg]
  std::uint32_t slot_count_ = 0, body_slots_ = 0, first_guard_ = 0;  // slots of guards: vertices, then edges
  std::vector<Eigen::Vector3d> rest_;
  std::vector<char> held_;
  std::vector<Triangle> triangles_;
  std::vector<TissueEdge> edges_;
  std::vector<std::uint32_t> vertices_;              // of the surface, ascending
  std::vector<std::uint32_t> body_of_;               // [vertex_count]
  std::vector<std::array<std::uint32_t, 3>> sides_;  // [triangle] its edges
  // [vertex_count]; softness: l / surface_modulus() [m/Pa]; viscosity: over stiffness [s]
  std::vector<double> areas_, softness_, viscosity_;
  struct BodyTree {
    BoxTree tree;
    std::vector<std::uint32_t> triangles;
  };
  std::vector<BodyTree> trees_;  // [body]

  // Of the step
  std::vector<Eigen::Vector3d> start_, end_;     // [vertex_count] x
  std::vector<Eigen::Vector3d> normals_;         // [triangle] outward, at the start
  std::vector<Eigen::Vector3d> vertex_normals_;  // [vertex_count] their sums, weighted by area, unit vectors
  std::vector<double> facing_;  // [vertex_count] cosine of the widest angle between that and the reverse of a face's
  std::vector<char> convex_;    // [edge] or pressed
  std::vector<char> near_;      // [vertex_count] to other surface
  std::vector<char> pressed_;   // [slot] in the step before
  std::vector<std::uint32_t> met_;  // [slot] PairRow::met of the step before
  std::vector<double> normal_;      // [slot] force that pairs start with [N]
  std::vector<PairRow> guards_;
  bool cuts_ = false;
  std::vector<char> raised_;  // [slot] since the last search
  std::vector<PairRow> rows_;
  std::vector<Candidate> crossings_;   // of edges
  std::vector<double> cost_;           // [slot] of the pair that holds it
  std::vector<std::uint32_t> holder_;  // [slot] in rows_, or none
  std::vector<char> claimed_;          // [slot] by a crossing that it remembers
};

}  // namespace fascia
