#include "render/surface_renderer.h"

#include "render/shadow_map.h"

namespace fascia {

SurfaceRenderer::SurfaceRenderer(gl::ProgramCache& programs, const SurfaceCorners& corners)
    : programs_(programs),
      normals_(programs.compute("draw/normals.comp")),
      depth_(programs.draw("draw/depth.vert", "draw/depth.frag")),
      corner_vertex_("surface corner_vertex", corners.vertex),
      fan_begin_("surface fan_begin", corners.fan_begin),
      fan_("surface fan", corners.fan),
      indices_("surface indices", corners.indices),
      position_("surface corner_position", corners.vertex.size() * 16),
      normal_("surface corner_normal", corners.vertex.size() * 16),
      corner_count_(static_cast<std::uint32_t>(corners.vertex.size())),
      index_count_(static_cast<GLsizei>(corners.indices.size())) {
  vertices_.set_vec4(0, position_);
  vertices_.set_vec4(1, normal_);
  vertices_.set_indices(indices_);
}

void SurfaceRenderer::update(const gl::Buffer& positions) {
  if (!pass_ || pass_positions_ != positions.id()) {
    pass_.emplace(normals_,
                  gl::ComputePass::Bindings{{"position", &positions},
                                            {"corner_vertex", &corner_vertex_},
                                            {"fan_begin", &fan_begin_},
                                            {"fan", &fan_},
                                            {"corner_position", &position_},
                                            {"corner_normal", &normal_}},
                  corner_count_);
    pass_positions_ = positions.id();
  }
  pass_->run();
}

void SurfaceRenderer::draw_depth() const {
  depth_.use();
  vertices_.bind();
  gl::DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

const gl::Program& SurfaceRenderer::program(const Look& look) const {
  const auto flag = [](bool on) { return std::string(on ? "1" : "0"); };
  return programs_.draw("draw/surface.vert", "draw/surface.frag",
                        {{"HEAT_MAP", flag(look.heat_map)},
                         {"SHADOW", flag(look.shadow)},
                         {"WIREFRAME", flag(look.wireframe)},
                         {"SHADOW_TAPS", "5"},
                         {"SHADOW_SIZE", std::to_string(ShadowMap::kSize) + ".0"}});
}

void SurfaceRenderer::draw(const Look& look) const {
  program(look).use();
  if (!look.wireframe) {
    vertices_.bind();
    gl::DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    return;
  }
  const GLuint views[] = {indices_.texel_view(GL_R32UI), position_.texel_view(GL_RGBA32F),
                          normal_.texel_view(GL_RGBA32F)};
  for (GLuint i = 0; i < 3; ++i) {
    gl::ActiveTexture(GL_TEXTURE1 + i);
    gl::BindTexture(GL_TEXTURE_BUFFER, views[i]);
  }
  no_vertices_.bind();
  gl::DrawArrays(GL_TRIANGLES, 0, index_count_);
}

}  // namespace fascia
