// Draws the surface on the GPU: computes normals from the deformed positions in each frame, then draws for the light
// and for the camera.
#pragma once
#include <optional>

#include "gl/compute_pass.h"
#include "render/passes/surface_corners.h"
#include "render/passes/vertex_array.h"
#include "render/view/look.h"

namespace fascia {

class SurfaceRenderer {
 public:
  SurfaceRenderer(gl::ProgramCache& programs, SurfaceCorners corners);
  /// Computes positions and normals of this frame. `positions` is vec4 [vertex_count].
  void update(const gl::Buffer& positions);
  /// Sets the region of every triangle, for looks that show them and for paints; empty frees them.
  void set_regions(std::span<const std::uint32_t> regions);
  bool has_regions() const { return static_cast<bool>(regions_); }
  void draw_depth(const Look& look) const;
  void draw_bare(const Look& look) const;  // as draw(), for depth and stencil only
  /// The shadow map, if any, must be bound to texture unit 0. `paints` of the regions: their texel view, 0 for one
  /// paint.
  void draw(const Look& look, GLuint paints);
  const gl::Buffer& corner_positions() const { return position_; }
  const gl::Buffer& corner_normals() const { return normal_; }

 private:
  void fill(const VertexArray& vertices) const;
  void draw_elements(const VertexArray& vertices) const;
  bool provide_rest();

  gl::ProgramCache& programs_;
  const gl::Program& normals_;
  gl::Buffer corner_vertex_, fan_begin_, fan_, indices_, position_, normal_, regions_;
  gl::Buffer color_;                   // vec4 [corner_count] linear, w 0: the paint's color; empty without colors
  std::vector<Eigen::Vector4f> rest_;  // [corner_count] until a look needs them, then
  gl::Buffer rest_buffer_;
  std::uint32_t corner_count_;
  GLsizei index_count_;
  VertexArray vertices_, detailed_vertices_, no_vertices_;
  std::optional<gl::ComputePass> pass_;
  const gl::Buffer* pass_positions_ = nullptr;  // buffer for which pass_ was recorded
  GLuint pass_positions_id_ = 0;                // and its OpenGL name then: a new buffer may have the same address
};

}  // namespace fascia
