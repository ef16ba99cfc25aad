// Smooths the edges of a picture that has one sample per pixel: a filter on its colors, in one pass.
#pragma once
#include "gl/program.h"
#include "gl/texture.h"
#include "render/passes/vertex_array.h"
#include "render/target/framebuffer.h"

namespace fascia {

class EdgeSmoothing {
 public:
  EdgeSmoothing(gl::ProgramCache& programs, int width, int height);
  ~EdgeSmoothing();
  EdgeSmoothing(const EdgeSmoothing&) = delete;
  EdgeSmoothing& operator=(const EdgeSmoothing&) = delete;
  bool fits(const Framebuffer& target) const {
    return target.width() == copy_.width() && target.height() == copy_.height();
  }
  /// Filters the picture in `target`, which has one sample and stays bound, with depth test on and blending off.
  void smooth(const Framebuffer& target) const;

 private:
  const gl::Program& program_;
  gl::Texture copy_;
  GLuint copy_target_;
  VertexArray no_vertices_;
};

}  // namespace fascia
