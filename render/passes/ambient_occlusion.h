// Ambient occlusion from the depth of the picture: creases, folds and gaps between tets get less light from around. It
// needs no geometry of its own, so it works for everything that is drawn, and its pattern stands still in the picture.
#pragma once
#include "gl/program.h"
#include "render/passes/vertex_array.h"
#include "render/target/framebuffer.h"
#include "render/view/camera.h"
#include "render/view/look.h"

namespace fascia {

class AmbientOcclusion {
 public:
  AmbientOcclusion(gl::ProgramCache& programs, int width, int height);
  ~AmbientOcclusion();
  AmbientOcclusion(const AmbientOcclusion&) = delete;
  AmbientOcclusion& operator=(const AmbientOcclusion&) = delete;

  bool fits(const Framebuffer& target) const {
    return target.width() == depth_.width() && target.height() == depth_.height();
  }
  /// Darkens what `target`, which is bound before and after, shows so far; where nothing was drawn it stays as it is.
  void darken(const Camera& camera, const Look& look, const Framebuffer& target) const;

 private:
  const gl::Program &gather_program_, &darken_program_;
  gl::Texture depth_, occlusion_;
  GLuint depth_target_ = 0, occlusion_target_ = 0;
  VertexArray no_vertices_;
};

}  // namespace fascia
