// The coarse level of the two-level method on the GPU: from the gradient to a smooth correction, R A_c^-1 R^T P^T g at
// the coarse nodes, with the rest matrix A_c and one rotation R per node, taken from the displacements of every
// iteration. The inverse is computed on another thread: the first one while other things are made, those for other
// materials or h while the old one serves.
#pragma once
#include <Eigen/Core>
#include <future>

#include "sim/coarse/coarse_space.h"
#include "sim/gpu/methods/method.h"

namespace fascia {

class CoarseLevel {
 public:
  CoarseLevel(const gl::ProgramCache& programs, const Model& model, const SolverSettings& settings);
  bool empty() const { return space_.node_count == 0; }  // a mesh too small to need it

  /// Two passes from `gradient` (vec4 [vertex_count]) to correction().
  Passes passes(const Recording& recording, const gl::Buffer& gradient) const;
  // P in rows of vertices (two_level_correct.comp): uint [vertex_count + 1], uvec4
  const gl::Buffer& row_begin() const { return row_begin_; }
  const gl::Buffer& rows() const { return rows_; }
  const gl::Buffer& correction() const { return correction_; }  // vec4 [node_count] [m]

  /// Whether the first inverse is computed; nothing can be solved before.
  bool ready() const;
  /// Waits until it is, and uploads it.
  void complete();
  /// Starts to compute the inverse if materials or h are other ones; one that waits for older values is let go.
  void values_changed(const Model& model, const SolverSettings& settings);
  /// What holds the body beside the tissue, from now on.
  void set_stiffness(const std::vector<VertexStiffness>& springs);
  /// Uploads an inverse for other values that is ready; with `wait`, waits until the newest is. Returns how many.
  int update(bool wait);
  /// Waits for so many inverses, or as many as are asked for, and uploads them.
  void take(int count);

 private:
  struct Job {  // a copy of what the thread needs: the model may change meanwhile
    Model model;
    double h;
  };
  static Eigen::MatrixXf compute(const CoarseSpace& space, const Job& job);
  void start(Job job);
  void take_next();
  void upload();

  CoarseSpace space_;
  std::uint32_t lanes_ = 1;         // invocations that share a node (shaders/common/group_sum.glsl)
  std::uint32_t row_octets_ = 0;    // uvec4 per row of the inverse, eight 16-bit integers each
  std::uint32_t most_entries_ = 0;  // of a node, in both lists that coarse_restrict goes through
  gl::Buffer node_begin_, gather_entry_, columns_, row_begin_, rows_;
  gl::Buffer rotation_, gradient_, inverse_rows_, scale_, correction_;
  Eigen::MatrixXf free_inverse_;  // without springs; empty before the first is taken
  std::vector<VertexStiffness> springs_;
  std::vector<Material> materials_;  // that the newest inverse is for, ready or not
  double h_ = 0;                     // [s]
  std::future<Eigen::MatrixXf> inverse_;
  std::optional<Job> next_;
};

}  // namespace fascia
