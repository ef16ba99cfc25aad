#include "render/passes/tet_renderer.h"

#include "render/passes/look_defines.h"

namespace fascia {
namespace {

constexpr int kCapTriangles = 2, kFaces = 4;  // per tet

}  // namespace

TetRenderer::TetRenderer(gl::ProgramCache& programs, const TetView& view)
    : programs_(programs),
      tets_("drawn tets", view.tets.size_bytes(), view.tets.data()),
      region_("drawn regions", view.region.size_bytes(), view.region.data()),
      tet_count_(static_cast<GLsizei>(view.tets.size())) {}

void TetRenderer::draw(const gl::Program& program, const gl::Buffer& positions, GLsizei vertices, GLuint paints) const {
  program.use();
  const GLuint views[] = {tets_.texel_view(GL_RGBA32UI), positions.texel_view(GL_RGBA32F), 0,
                          region_.texel_view(GL_R32UI)};
  for (GLuint i = 0; i < 4; ++i) {
    gl::ActiveTexture(GL_TEXTURE1 + i);
    gl::BindTexture(GL_TEXTURE_BUFFER, views[i]);
  }
  if (paints != 0) {
    gl::ActiveTexture(GL_TEXTURE7);
    gl::BindTexture(GL_TEXTURE_BUFFER, paints);
  }
  no_vertices_.bind();
  positions.before_draw(GL_TEXTURE_FETCH_BARRIER_BIT);
  gl::DrawArrays(GL_TRIANGLES, 0, vertices);
}

void TetRenderer::draw_cap(const Look& look, const gl::Buffer& positions, GLuint paints) const {
  DrawnTriangles drawn;
  drawn.triangles = kCapTriangles;
  drawn.cap = true;
  drawn.paints = paints != 0;
  draw(programs_.draw("draw/cap.vert", "draw/surface.frag", tissue_defines(look, drawn)), positions,
       3 * kCapTriangles * tet_count_, paints);
}

void TetRenderer::draw_flesh(const Look& look) const {
  Look plain = look;
  plain.heat_map = plain.regions = plain.wireframe = false;
  DrawnTriangles drawn;
  drawn.cap = true;
  programs_.draw("draw/section_plane.vert", "draw/surface.frag", tissue_defines(plain, drawn)).use();
  no_vertices_.bind();
  gl::DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void TetRenderer::draw_tets(const Look& look, const gl::Buffer& positions, GLuint paints) const {
  DrawnTriangles drawn;
  drawn.triangles = kFaces;
  drawn.paints = paints != 0;
  draw(programs_.draw("draw/tets.vert", "draw/surface.frag", tissue_defines(look, drawn)), positions,
       3 * kFaces * tet_count_, paints);
}

void TetRenderer::draw_depth(const Look& look, const gl::Buffer& positions) const {
  draw(programs_.draw("draw/tets.vert", "draw/depth.frag", depth_defines(look)), positions, 3 * kFaces * tet_count_);
}

}  // namespace fascia
