#include "render/passes/rigid_renderer.h"

#include "render/passes/look_defines.h"

namespace fascia {

void RigidRenderer::set(const RigidSurface& surface) {
  const std::size_t bytes = surface.positions.size() * sizeof(Eigen::Vector4f);
  if (position_.bytes() != bytes || tinted_ == surface.tints.empty() ||
      static_cast<std::size_t>(index_count_) != 3 * surface.triangles.size()) {
    index_count_ = static_cast<GLsizei>(3 * surface.triangles.size());
    tinted_ = !surface.tints.empty();
    if (empty()) return;
    position_ = gl::Buffer("rigid position", surface.positions);
    normal_ = gl::Buffer("rigid normal", surface.normals);
    indices_ = gl::Buffer("rigid indices", surface.triangles);
    vertices_.set_vec4(0, position_);
    vertices_.set_vec4(1, normal_);
    if (tinted_) {
      tint_ = gl::Buffer("rigid tint", surface.tints);
      vertices_.set_vec4(2, tint_);
    }
    vertices_.set_indices(indices_);
    return;
  }
  if (empty()) return;
  position_.upload(0, bytes, surface.positions.data());
  normal_.upload(0, bytes, surface.normals.data());
  if (tinted_) tint_.upload(0, bytes, surface.tints.data());
}

void RigidRenderer::draw_depth(const Look& look) const {
  if (empty()) return;
  Look whole = look;
  whole.section.reset();
  programs_.draw("draw/surface.vert", "draw/depth.frag", depth_defines(whole)).use();
  vertices_.bind();
  gl::DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

void RigidRenderer::draw(const Look& look) const {
  if (empty()) return;
  Look plain = look;
  plain.section.reset();
  plain.heat_map = plain.regions = plain.wireframe = false;
  plain.quality.detail = false;
  programs_.draw("draw/surface.vert", "draw/metal.frag", tissue_defines(plain, {.colored = tinted_})).use();
  vertices_.bind();
  gl::DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace fascia
