// Ambient occlusion from the depth of the picture: creases, folds and gaps between tets get less ambient light. It
// needs no geometry of its own, so it works for everything that is drawn, and its pattern is fixed in the picture.
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
  /// Darkens the current content of `target`, which is bound before and after; pixels without geometry are unchanged.
  void darken(const Camera& camera, const Look& look, const Framebuffer& target) const;

 private:
  const gl::Program &gather_program_, &darken_program_;
  gl::Texture depth_, occlusion_;
  GLuint depth_target_ = 0, occlusion_target_ = 0;
  VertexArray no_vertices_;
};

}  // namespace fascia
