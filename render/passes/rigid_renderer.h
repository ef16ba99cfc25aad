// Draws rigid things of metal beside the tissue, such as instruments, for the light and for the camera.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gl/program.h"
#include "render/passes/vertex_array.h"
#include "render/view/look.h"

namespace fascia {

/// Triangles of all rigid things of a picture at their places.
struct RigidSurface {
  std::vector<Eigen::Vector4f> positions, normals;  // [vertex] xyz
  std::vector<Eigen::Vector4f> tints;               // [vertex] color and its share of that of the metal; empty: none
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

class RigidRenderer {
 public:
  explicit RigidRenderer(gl::ProgramCache& programs) : programs_(programs) {}
  /// Keeps its buffers while the numbers of vertices and triangles stay the same.
  void set(const RigidSurface& surface);
  bool empty() const { return index_count_ == 0; }
  void draw_depth(const Look& look) const;
  /// The shadow map, if any, must be bound to texture unit 0.
  void draw(const Look& look) const;

 private:
  gl::ProgramCache& programs_;
  gl::Buffer position_, normal_, tint_, indices_;
  GLsizei index_count_ = 0;
  bool tinted_ = false;
  VertexArray vertices_;
};

}  // namespace fascia
