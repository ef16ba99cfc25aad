#include "render/passes/marks.h"

#include "render/passes/look_defines.h"

namespace fascia {

Marks::Marks(gl::ProgramCache& programs, std::span<const std::uint32_t> fixed)
    : programs_(programs), arrow_program_(programs.draw("draw/arrow.vert", "draw/arrow.frag")) {
  fixed_.set("fixed dots", fixed);
}

void Marks::set_grabbed(std::span<const std::uint32_t> vertices) { grabbed_.set("grabbed dots", vertices); }

void Marks::Dots::set(const char* label, std::span<const std::uint32_t> list) {
  count = static_cast<GLsizei>(list.size());
  if (list.empty()) return;
  if (list.size_bytes() > vertices.bytes()) {
    vertices = gl::Buffer(label, list.size_bytes(), list.data());
    vertex_array.set_instance_uint(0, vertices);
  } else {
    vertices.upload(0, list.size_bytes(), list.data());
  }
}

void Marks::draw_dots(const gl::Program& program, const Dots& dots, const Style& style) const {
  if (dots.count == 0) return;
  program.set("radius", style.radius);
  program.set("fill", style.fill.x(), style.fill.y(), style.fill.z(), style.fill.w());
  program.set("border", style.border.x(), style.border.y(), style.border.z(), style.border.w());
  dots.vertex_array.bind();
  gl::DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, dots.count);
}

void Marks::draw(const Look& look, const gl::Buffer& positions, std::span<const GrabArrow> grabs) const {
  const bool has_fixed = look.fixed_dots && fixed_.count > 0;
  if (!has_fixed && grabbed_.count == 0 && grabs.empty()) return;
  static const Style kFixed{3.0f, {0.15f, 0.19f, 0.27f, 1}, {0.95f, 0.96f, 0.98f, 1}};
  static const Style kGrabbed{4.0f, {1.00f, 0.80f, 0.20f, 1}, {1, 1, 1, 1}};
  gl::Enable(GL_BLEND);
  gl::BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl::DepthMask(GL_FALSE);
  const gl::Program& dots =
      programs_.draw("draw/dots.vert", "draw/dots.frag", {{"SECTION", flag(look.section.has_value())}});
  dots.use();
  gl::ActiveTexture(GL_TEXTURE0);
  gl::BindTexture(GL_TEXTURE_BUFFER, positions.texel_view(GL_RGBA32F));
  positions.before_draw(GL_TEXTURE_FETCH_BARRIER_BIT);
  if (has_fixed) draw_dots(dots, fixed_, kFixed);
  draw_dots(dots, grabbed_, kGrabbed);
  if (!grabs.empty()) {
    gl::Disable(GL_DEPTH_TEST);
    arrow_program_.use();
    no_vertices_.bind();
    for (const GrabArrow& grab : grabs) {
      arrow_program_.set("from", grab.from.x(), grab.from.y(), grab.from.z(), 1);
      arrow_program_.set("to", grab.to.x(), grab.to.y(), grab.to.z(), 1);
      gl::DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    gl::Enable(GL_DEPTH_TEST);
  }
  gl::DepthMask(GL_TRUE);
  gl::Disable(GL_BLEND);
}

}  // namespace fascia
