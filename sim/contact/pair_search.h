// Finds where tissue may touch tissue in a step: other bodies, and itself.
//
// Bodies are solid, so that the sides of a surface are known: a vertex in front of a face has a positive gap along the
// face's outward normal, one behind it a negative one, and both are pressed to the same place. Convex edges that cross
// are the other kind of contact. Which pairs are possible is what the normals say (the Gauss maps of two surfaces that
// touch meet: Gottschalk 2000): a vertex and a face whose outward normals oppose each other, two edges whose arcs of
// normals cross. Gap, normal and weights are those of the moment within the step at which the pair would touch if all
// vertices moved on straight; they stay constant within the step, which so has one smooth energy.
//
// Each vertex remembers a force for every other body (up to kBodySlots), and each edge for one other edge: pairs that
// slide along a surface keep their force. Of several pairs for one slot the nearest is taken.
#pragma once
#include <vector>

#include "sim/contact/box_tree.h"
#include "sim/contact/pair_row.h"
#include "sim/contact/tissue_surface.h"

namespace fascia {

class PairSearch {
 public:
  static constexpr std::uint32_t kBodySlots = 4;

  /// Empty if no tissue of the model touches tissue.
  explicit PairSearch(const Model& model);
  void materials_changed(const Model& model);

  bool empty() const { return slot_count_ == 0; }
  std::uint32_t slot_count() const { return slot_count_; }
  double skin() const { return skin_; }  // [m] the gap that is left between surfaces

  /// The pairs of a step, by ascending slot. `start` and `end`: displacements [vertex_count] at the start, and where
  /// velocities lead [m].
  std::vector<PairRow> find(const std::vector<Eigen::Vector3d>& start, const std::vector<Eigen::Vector3d>& end);

 private:
  struct Side;
  struct Candidate;
  void place(const std::vector<Eigen::Vector3d>& start, const std::vector<Eigen::Vector3d>& end);
  void offer(const Candidate& candidate);
  void look_at_vertex(std::size_t index, std::uint32_t body);
  void look_at_edge(std::uint32_t edge, std::uint32_t body);
  void try_vertex(std::uint32_t vertex, std::size_t index, std::uint32_t triangle);
  void try_edges(std::uint32_t first, std::uint32_t second);
  bool may_touch(std::uint32_t a, std::uint32_t b) const { return a == b ? self_ : bodies_; }
  double way_of(std::uint32_t v) const { return (end_[v] - start_[v]).norm(); }

  bool self_ = false, bodies_ = false;
  double skin_ = 0, edge_ = 0;  // [m]; edge: the mean length of edges
  double penalty_ = 0;
  std::uint32_t slot_count_ = 0, body_slots_ = 0;
  std::vector<Eigen::Vector3d> rest_;
  std::vector<char> held_;
  std::vector<Triangle> triangles_;
  std::vector<TissueEdge> edges_;
  std::vector<std::uint32_t> vertices_;              // of the surface, ascending
  std::vector<std::uint32_t> body_of_;               // [vertex_count]
  std::vector<std::array<std::uint32_t, 3>> sides_;  // [triangle] its edges
  std::vector<double> areas_, softness_;             // [vertex_count]; softness: l / (lambda + 2 mu) [m/Pa]
  struct BodyTree {
    BoxTree tree;
    std::vector<std::uint32_t> triangles;
  };
  std::vector<BodyTree> trees_;  // [body]

  // Of the step
  std::vector<Eigen::Vector3d> start_, end_;      // [vertex_count] x
  std::vector<Eigen::Vector3d> normals_;          // [triangle] outward, at the start
  std::vector<Eigen::Vector3d> vertex_normals_;   // [vertex_count] their sums, weighted by area
  std::vector<char> convex_;                      // [edge]
  std::vector<PairRow> rows_;
  std::vector<double> cost_;            // [slot] of the pair that holds it
  std::vector<std::uint32_t> holder_;   // [slot] in rows_, or none
};

}  // namespace fascia
