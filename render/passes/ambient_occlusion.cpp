#include "render/passes/ambient_occlusion.h"

namespace fascia {
namespace {

constexpr double kReach = 0.3;  // search radius for occluders, in scene radii

void bind(GLuint unit, const gl::Texture& texture) {
  gl::ActiveTexture(GL_TEXTURE0 + unit);
  gl::BindTexture(GL_TEXTURE_2D, texture.id());
}

}  // namespace

AmbientOcclusion::AmbientOcclusion(gl::ProgramCache& programs, int width, int height)
    : gather_program_(programs.draw("draw/fullscreen.vert", "draw/occlusion.frag")),
      darken_program_(programs.draw("draw/fullscreen.vert", "draw/occlusion_darken.frag")),
      depth_("picture depth", GL_DEPTH24_STENCIL8, width, height),
      occlusion_("ambient occlusion", GL_RGBA8, width, height),
      depth_target_(gl::make_target(GL_DEPTH_STENCIL_ATTACHMENT, depth_)),
      occlusion_target_(gl::make_target(GL_COLOR_ATTACHMENT0, occlusion_)) {}

AmbientOcclusion::~AmbientOcclusion() {
  const GLuint targets[] = {depth_target_, occlusion_target_};
  gl::DeleteFramebuffers(2, targets);
}

void AmbientOcclusion::darken(const Camera& camera, const Look& look, const Framebuffer& target) const {
  const int width = target.width(), height = target.height();
  gl::BindFramebuffer(GL_READ_FRAMEBUFFER, target.draw_id());
  gl::BindFramebuffer(GL_DRAW_FRAMEBUFFER, depth_target_);
  gl::BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);

  const Eigen::Matrix4f projection = camera.projection(double(width) / height, look.radius);
  const auto describe = [&](const gl::Program& program) {
    program.use();
    program.set("unproject", 1 / projection(0, 0), 1 / projection(1, 1), projection(2, 2), projection(2, 3));
    program.set("occlusion", static_cast<float>(kReach * look.radius), look.ambient_occlusion, projection(0, 2),
                projection(1, 2));
  };
  gl::Disable(GL_DEPTH_TEST);
  no_vertices_.bind();
  gl::BindFramebuffer(GL_FRAMEBUFFER, occlusion_target_);
  describe(gather_program_);
  bind(0, depth_);
  gl::DrawArrays(GL_TRIANGLES, 0, 3);

  target.bind();
  gl::Enable(GL_BLEND);
  gl::BlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  describe(darken_program_);
  bind(1, occlusion_);
  gl::DrawArrays(GL_TRIANGLES, 0, 3);
  gl::Disable(GL_BLEND);
  gl::Enable(GL_DEPTH_TEST);
}

}  // namespace fascia
