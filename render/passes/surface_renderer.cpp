#include "render/passes/surface_renderer.h"

#include <array>
#include <utility>

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

SurfaceRenderer::SurfaceRenderer(gl::ProgramCache& programs, SurfaceCorners corners)
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
  rest_ = std::move(corners.rest);
  if (!corners.colors.empty()) color_ = gl::Buffer("surface corner_color", linear_colors(corners.colors));
  fill(vertices_);
}

void SurfaceRenderer::fill(const VertexArray& vertices) const {
  vertices.set_vec4(0, position_);
  vertices.set_vec4(1, normal_);
  if (color_) vertices.set_vec4(2, color_);
  vertices.set_indices(indices_);
}

// Whether there are rest positions, which the first detailed picture uploads.
bool SurfaceRenderer::provide_rest() {
  if (!rest_.empty()) {
    rest_buffer_ = gl::Buffer("surface corner_rest", rest_);
    rest_ = {};
    fill(detailed_vertices_);
    detailed_vertices_.set_vec4(3, rest_buffer_);
  }
  return static_cast<bool>(rest_buffer_);
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

void SurfaceRenderer::draw_elements(const VertexArray& vertices) const {
  vertices.bind();
  for (const gl::Buffer* buffer : {&position_, &normal_}) buffer->before_draw(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
  gl::DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

void SurfaceRenderer::draw_depth(const Look& look) const {
  programs_.draw("draw/surface.vert", "draw/depth.frag", depth_defines(look)).use();
  draw_elements(vertices_);
}

void SurfaceRenderer::draw_bare(const Look& look) const {
  Look bare;
  bare.shadow = false;
  bare.section = look.section;
  programs_.draw("draw/surface.vert", "draw/depth.frag", tissue_defines(bare, {})).use();
  draw_elements(vertices_);
}

void SurfaceRenderer::draw(const Look& look, GLuint paints) {
  const bool plain = !look.heat_map && !look.regions, colored = color_ && plain,
             detailed = plain && look.quality.detail && provide_rest(),
             by_region = look.regions || (plain && paints != 0);
  DrawnTriangles drawn;
  drawn.colored = colored;
  drawn.detailed = detailed;
  drawn.paints = paints != 0;
  // All views are created before any is bound, because creating one binds it to the active unit.
  std::array<GLuint, 8> views{};  // by texture unit
  if (by_region) views[4] = regions_.texel_view(GL_R32UI);
  if (plain) views[7] = paints;
  if (look.wireframe) {
    views[1] = indices_.texel_view(GL_R32UI);
    views[2] = position_.texel_view(GL_RGBA32F);
    views[3] = normal_.texel_view(GL_RGBA32F);
    if (colored) views[5] = color_.texel_view(GL_RGBA32F);
    if (detailed) views[6] = rest_buffer_.texel_view(GL_RGBA32F);
  }
  for (GLuint unit = 0; unit < views.size(); ++unit) {
    if (views[unit] == 0) continue;
    gl::ActiveTexture(GL_TEXTURE0 + unit);
    gl::BindTexture(GL_TEXTURE_BUFFER, views[unit]);
  }
  programs_.draw("draw/surface.vert", "draw/surface.frag", tissue_defines(look, drawn)).use();
  if (look.wireframe) {
    no_vertices_.bind();
    for (const gl::Buffer* buffer : {&position_, &normal_}) buffer->before_draw(GL_TEXTURE_FETCH_BARRIER_BIT);
    gl::DrawArrays(GL_TRIANGLES, 0, index_count_);
  } else {
    draw_elements(detailed ? detailed_vertices_ : vertices_);
  }
}

}  // namespace fascia
