// Draws tets from the solver's positions, without a buffer of triangles: the cut of a section plane, and separate tets.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "gl/program.h"
#include "render/passes/vertex_array.h"
#include "render/view/look.h"

namespace fascia {

/// Vertices and region of each tet.
struct TetView {
  std::span<const std::array<std::uint32_t, 4>> tets;
  std::span<const std::uint32_t> region;  // [tets]
  // The drawn surface is closed and is not the boundary of these tets: a section ends at the surface
  bool within_surface = false;
};

class TetRenderer {
 public:
  TetRenderer(gl::ProgramCache& programs, const TetView& view);
  /// `paints` of the regions: their texel view, 0 for one paint.
  void draw_cap(const Look& look, const gl::Buffer& positions, GLuint paints) const;
  void draw_flesh(const Look& look) const;  // the whole section plane, as the inside of tissue without tets
  /// The shadow map, if any, must be bound to texture unit 0.
  void draw_tets(const Look& look, const gl::Buffer& positions, GLuint paints) const;
  void draw_depth(const Look& look, const gl::Buffer& positions) const;  // of separate tets

 private:
  void draw(const gl::Program& program, const gl::Buffer& positions, GLsizei vertices, GLuint paints = 0) const;
  gl::ProgramCache& programs_;
  gl::Buffer tets_, region_;
  GLsizei tet_count_;
  VertexArray no_vertices_;
};

}  // namespace fascia
