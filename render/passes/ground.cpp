#include "render/passes/ground.h"

#include <cmath>

#include "render/passes/look_defines.h"
#include "render/view/camera.h"

namespace fascia {
namespace {

// Vertices of the cells around the shadow map's, and of that one.
constexpr GLint kAround = 48, kMiddle = 6;

}  // namespace

GridScale grid_scale(double scene_radius) {
  // About eight fine lines across the scene.
  const double wanted = scene_radius / 4, decade = std::pow(10.0, std::floor(std::log10(wanted)));
  if (wanted >= 5 * decade) return {5 * decade, 2};
  if (wanted >= 2 * decade) return {2 * decade, 5};
  return {decade, 5};
}

Ground::Ground(gl::ProgramCache& programs) : programs_(programs) {}

void Ground::lay(const Look& look, FrameUniforms& frame) {
  const Eigen::Matrix3d standing = standing_axes(look.up);
  const GridScale scale = grid_scale(look.radius);
  frame.grid_x << standing.col(0).cast<float>(), float(scale.spacing);
  frame.grid_z << standing.col(2).cast<float>(), 1 / float(scale.strong);
}

const gl::Program& Ground::program(const Look& look, bool shadow) const {
  gl::Defines defines = backdrop_defines(look);
  defines.emplace_back("SHADOW", flag(shadow));
  return programs_.draw("draw/ground/ground.vert", "draw/ground/ground.frag", defines);
}

void Ground::draw_unshadowed(const Look& look) const {
  if (look.backdrop == Backdrop::transparent) return;
  no_vertices_.bind();
  program(look, false).use();
  gl::DrawArrays(GL_TRIANGLES, 0, look.shadow ? kAround : kAround + kMiddle);
}

void Ground::draw_shadowed(const Look& look) const {
  if (!look.shadow) return;
  no_vertices_.bind();
  program(look, true).use();
  gl::DrawArrays(GL_TRIANGLES, kAround, kMiddle);
}

void Ground::draw_background(const Look& look) const {
  no_vertices_.bind();
  programs_.draw("draw/fullscreen.vert", "draw/ground/background.frag", backdrop_defines(look)).use();
  gl::DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace fascia
