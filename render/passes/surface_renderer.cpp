#include "render/passes/surface_renderer.h"

#include "render/passes/look_defines.h"

namespace fascia {
namespace {

std::vector<Eigen::Vector4f> linear_colors(const std::vector<std::uint32_t>& colors) {
  std::vector<Eigen::Vector4f> linear;
  linear.reserve(colors.size());
  const auto share = [](std::uint32_t byte) { return static_cast<float>(byte & 255) / 255; };
  for (const std::uint32_t c : colors) {
    Eigen::Vector4f& out = linear.emplace_back(share(c), share(c >> 8), share(c >> 16), share(c >> 24));
    for (int k = 0; k < 3; ++k) out[k] = linear_of_srgb(out[k]);
  }
  return linear;
}

}  // namespace

SurfaceRenderer::SurfaceRenderer(gl::ProgramCache& programs, const SurfaceCorners& corners)
    : programs_(programs),
      normals_(programs.compute("draw/normals.comp")),
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
  if (corners.colors.empty()) return;
  color_ = gl::Buffer("surface corner_color", linear_colors(corners.colors));
  vertices_.set_vec4(2, color_);
}

void SurfaceRenderer::update(const gl::Buffer& positions) {
  if (!pass_ || pass_positions_ != &positions || pass_positions_id_ != positions.id()) {
    pass_.emplace(normals_,
                  gl::ComputePass::Bindings{{"position", &positions},
                                            {"corner_vertex", &corner_vertex_},
                                            {"fan_begin", &fan_begin_},
                                            {"fan", &fan_},
                                            {"corner_position", &position_},
                                            {"corner_normal", &normal_}},
                  corner_count_);
    pass_positions_ = &positions;
    pass_positions_id_ = positions.id();
  }
  pass_->run();
}

void SurfaceRenderer::set_regions(std::span<const std::uint32_t> regions) {
  regions_ = regions.empty() ? gl::Buffer() : gl::Buffer("surface regions", regions.size_bytes(), regions.data());
}

void SurfaceRenderer::draw_depth(const Look& look) const {
  programs_.draw("draw/surface.vert", "draw/depth.frag", depth_defines(look)).use();
  vertices_.bind();
  gl::DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

void SurfaceRenderer::draw_bare(const Look& look) const {
  Look bare;
  bare.shadow = false;
  bare.section = look.section;
  programs_.draw("draw/surface.vert", "draw/depth.frag", tissue_defines(bare, false, 1)).use();
  vertices_.bind();
  gl::DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

void SurfaceRenderer::draw(const Look& look) const {
  const bool colored = color_ && !look.heat_map && !look.regions;
  const GLuint regions = look.regions ? regions_.texel_view(GL_R32UI) : 0,
               colors = look.wireframe && colored ? color_.texel_view(GL_RGBA32F) : 0;
  programs_.draw("draw/surface.vert", "draw/surface.frag", tissue_defines(look, false, 1, colored)).use();
  const auto bind = [](GLuint unit, GLuint view) {
    gl::ActiveTexture(GL_TEXTURE0 + unit);
    gl::BindTexture(GL_TEXTURE_BUFFER, view);
  };
  if (!look.wireframe) {
    if (look.regions) bind(4, regions);
    vertices_.bind();
    gl::DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    return;
  }
  // All views are created before any is bound, because creating one binds it to the active unit.
  const GLuint views[] = {indices_.texel_view(GL_R32UI), position_.texel_view(GL_RGBA32F),
                          normal_.texel_view(GL_RGBA32F)};
  for (GLuint i = 0; i < 3; ++i) bind(1 + i, views[i]);
  if (look.regions || colored) bind(4, look.regions ? regions : colors);
  no_vertices_.bind();
  gl::DrawArrays(GL_TRIANGLES, 0, index_count_);
}

}  // namespace fascia
