// The coarse level of the two-level method on the GPU: from the gradient to a smooth correction, R A_c^-1 R^T P^T g at
// the coarse nodes, with the rest matrix A_c and one rotation R per node, taken from the displacements of every
// iteration. The inverse is computed on another thread: the first one during setup, later ones for other materials or h
// while the old one is in use.
#pragma once
#include <Eigen/Core>
#include <future>

#include "sim/coarse/coarse_contact.h"
#include "sim/coarse/coarse_space.h"
#include "sim/gpu/methods/method.h"

namespace fascia {

class CoarseLevel {
 public:
  CoarseLevel(const gl::ProgramCache& programs, const Model& model, const SolverSettings& settings);
  bool empty() const { return space_.node_count == 0; }  // a mesh too small to need it

  /// In scenes with contact: computes the rotations for set_contact().
  Passes begin(const Recording& recording, const gl::Buffer& gradient) const;
  /// Two passes from `gradient` (vec4 [vertex_count]) to correction(), and two more in scenes with contact.
  Passes passes(const Recording& recording, const gl::Buffer& gradient) const;
  // P by rows of vertices (two_level_correct.comp): uint [vertex_count + 1], uvec4
  const gl::Buffer& row_begin() const { return row_begin_; }
  const gl::Buffer& rows() const { return rows_; }
  const gl::Buffer& correction() const { return correction_; }  // vec4 [node_count] [m]

  /// Whether the first inverse is computed; the solver cannot step before.
  bool ready() const;
  /// Waits for the first inverse and uploads it.
  void complete();
  /// Starts to compute the inverse if materials or h have changed; discards a request that still waits with older
  /// values.
  void values_changed(const Model& model, const SolverSettings& settings);
  /// Whether K of quadratic tets is relaxed; computes the inverse if that has changed.
  void relax(const Model& model, bool relaxed);
  /// The rotations of the nodes, before each set_contact().
  void read_for_contact(gl::Downloads& downloads);
  /// Sets the stiffness of contact, unless the last one serves again.
  void set_contact(const std::vector<PointStiffness>& points);
  void forget_contact() { keeps_contact_ = false; }  // the last one does not serve again
  /// Sets the stiffness that springs add to that of the tissue.
  void set_stiffness(const std::vector<VertexStiffness>& springs);
  /// Uploads a finished inverse for new values; with `wait`, waits for the newest one. Returns the number of inverses
  /// uploaded.
  int update(bool wait);
  /// Waits for up to `count` of the requested inverses and uploads them.
  void take(int count);

 private:
  struct Job {  // a copy of the thread's input: the model may change meanwhile
    Model model;
    double h;
  };
  static Eigen::MatrixXf compute(const CoarseSpace& space, const Job& job);
  void start(Job job);
  void request(const Model& model);
  void take_next();
  void upload();
  void upload_contact();
  gl::ComputePass restriction(const Recording& recording, const gl::Buffer& gradient) const;

  CoarseSpace space_;
  bool relaxed_;
  std::uint32_t lanes_ = 1;         // invocations that share a node (shaders/common/group_sum.glsl)
  std::uint32_t row_octets_ = 0;    // uvec4 per row of the inverse, eight 16-bit integers each
  std::uint32_t most_entries_ = 0;  // largest number of entries of a node in either list of coarse_restrict
  gl::Buffer node_begin_, gather_entry_, columns_, row_begin_, rows_;
  gl::Buffer rotation_, gradient_, inverse_rows_, scale_, correction_;
  gl::Buffer touched_, contact_matrix_, free_;  // with contact only
  Eigen::MatrixXf free_inverse_;                // without springs; empty before the first upload
  std::vector<std::int16_t> quantized_;         // inverse_rows_
  Eigen::VectorXf scales_;                      // of its rows
  PointFunctions point_functions_;
  TouchedNodes contact_;
  Eigen::MatrixXf contact_stiffness_;
  NodeCompliance compliance_;                 // of its nodes; empty after upload()
  std::vector<shared::vec4> node_rotations_;  // of the GPU, for set_contact()
  bool keeps_contact_ = false;
  std::vector<VertexStiffness> springs_;
  std::vector<Material> materials_;  // of the newest inverse, ready or not
  double h_ = 0;                     // [s]
  std::future<Eigen::MatrixXf> inverse_;
  std::optional<Job> next_;
};

}  // namespace fascia
