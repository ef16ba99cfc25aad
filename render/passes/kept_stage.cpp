#include "render/passes/kept_stage.h"

namespace fascia {

bool KeptStage::begin(const Ground& ground, const FrameUniforms& frame, const Look& look, bool with_ground,
                      const Framebuffer& target) {
  const bool pays = gl::device().software && target.samples() == 1 && look.backdrop != Backdrop::transparent &&
                    look.ambient_occlusion <= 0;
  if (!pays) {
    last_.reset();
    kept_.reset();
    return false;
  }
  const View view{
      target.width(),
      target.height(),
      with_ground,
      look.shadow,
      look.backdrop,
      {frame.view_projection[0], frame.view_projection[1], frame.view_projection[2], frame.view_projection[3],
       frame.picture, frame.center, frame.ground_origin, frame.ground_u, frame.ground_v, frame.grid_x, frame.grid_z}};
  if (last_ != view) {
    last_ = view;
    kept_.reset();
    return false;
  }
  if (!kept_) {
    kept_.emplace(target.width(), target.height(), 1);
    kept_->bind();
    gl::Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    if (with_ground) ground.draw_unshadowed(look);
    ground.draw_background(look);
  }
  gl::BindFramebuffer(GL_READ_FRAMEBUFFER, kept_->draw_id());
  gl::BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.draw_id());
  gl::BlitFramebuffer(0, 0, target.width(), target.height(), 0, 0, target.width(), target.height(),
                      GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
  target.bind();
  return true;
}

}  // namespace fascia
