// Where the iterations of a stage start, of each body in contact: how far the first step takes it before it meets
// something, and the forces that carried it at the end of the stage before (shaders/sim/contact/support.glsl). Kernels
// add what the pieces of tools say.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/gpu/contact/pair_stage.h"

namespace fascia {

inline constexpr std::uint32_t kNoBody = ~0u;  // NO_BODY of shaders/sim/contact

class BodyStarts {
 public:
  BodyStarts() = default;
  /// `points` [point] their first vertices, at places of the buffers' vertices.
  BodyStarts(const Model& model, const SimBuffers& buffers, const std::vector<std::uint32_t>& points);

  void materials_changed(const Model& model);
  /// For a stage in which the tissue has these pairs.
  void begin(const Eigen::Vector3d& gravity, const PairStage& pairs);
  /// Iterations start where the tissue is, and not where velocities lead.
  void stay();

  bool meets() const;  // whether some body meets other tissue in the stage

  std::uint32_t body_count() const { return static_cast<std::uint32_t>(shares_.size()); }
  const gl::Buffer& bodies() const { return bodies_; }  // contact_bodies
  const gl::Buffer& body_of_vertex() const {
    return vertices_;
  }  // uint [2 * vertex_count]: whose share, own; or kNoBody

 private:
  void upload_leaders();

  std::vector<float> shares_;                              // [body] of the first step that is free
  std::vector<double> masses_;                             // [body] [kg]; 0 for those that start without gravity
  std::vector<std::uint32_t> leaders_, uploaded_leaders_;  // [body] whose share it takes
  std::vector<std::uint32_t> own_, points_;  // [place of a vertex] its body, kNoBody if held; [point] its vertex
  std::vector<char> held_;                   // [body] some of its vertices are
  gl::Buffer bodies_, vertices_;
};

}  // namespace fascia
