#include "render/passes/edge_smoothing.h"

namespace fascia {

EdgeSmoothing::EdgeSmoothing(gl::ProgramCache& programs, int width, int height)
    : program_(programs.draw("draw/fullscreen.vert", "draw/edge_smoothing.frag")),
      copy_("picture before smoothing", GL_RGBA8, width, height),
      copy_target_(gl::make_target(GL_COLOR_ATTACHMENT0, copy_)) {}

EdgeSmoothing::~EdgeSmoothing() { gl::DeleteFramebuffers(1, &copy_target_); }

void EdgeSmoothing::smooth(const Framebuffer& target) const {
  const int width = target.width(), height = target.height();
  gl::BindFramebuffer(GL_READ_FRAMEBUFFER, target.draw_id());
  gl::BindFramebuffer(GL_DRAW_FRAMEBUFFER, copy_target_);
  gl::BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  target.bind();
  gl::Disable(GL_DEPTH_TEST);
  gl::ActiveTexture(GL_TEXTURE0);
  gl::BindTexture(GL_TEXTURE_2D, copy_.id());
  program_.use();
  no_vertices_.bind();
  gl::DrawArrays(GL_TRIANGLES, 0, 3);
  gl::Enable(GL_DEPTH_TEST);
}

}  // namespace fascia
