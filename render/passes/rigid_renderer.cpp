#include "render/passes/rigid_renderer.h"

#include "render/passes/look_defines.h"

namespace fascia {

void RigidRenderer::set(const RigidSurface& surface) {
  const std::size_t bytes = surface.positions.size() * sizeof(Eigen::Vector4f);
  if (position_.bytes() != bytes || static_cast<std::size_t>(index_count_) != 3 * surface.triangles.size()) {
    index_count_ = static_cast<GLsizei>(3 * surface.triangles.size());
    if (empty()) return;
    position_ = gl::Buffer("rigid position", surface.positions);
    normal_ = gl::Buffer("rigid normal", surface.normals);
    indices_ = gl::Buffer("rigid indices", surface.triangles);
    vertices_.set_vec4(0, position_);
    vertices_.set_vec4(1, normal_);
    vertices_.set_indices(indices_);
    return;
  }
  if (empty()) return;
  position_.upload(0, bytes, surface.positions.data());
  normal_.upload(0, bytes, surface.normals.data());
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
  programs_.draw("draw/surface.vert", "draw/metal.frag", tissue_defines(plain, {})).use();
  vertices_.bind();
  gl::DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace fascia
