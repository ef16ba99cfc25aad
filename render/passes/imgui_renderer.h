// Draws Dear ImGui's draw lists with fascia's own function table, so panels look the same in a window, under OSMesa and
// under EGL.
#pragma once
#include "gl/program.h"
#include "gl/texture.h"

struct ImDrawData;

namespace fascia {

class ImguiRenderer {
 public:
  /// Uploads the font atlas of the current ImGui context and registers itself with it. Fonts added later need a new
  /// renderer.
  explicit ImguiRenderer(gl::ProgramCache& programs);
  ~ImguiRenderer();
  ImguiRenderer(const ImguiRenderer&) = delete;
  ImguiRenderer& operator=(const ImguiRenderer&) = delete;
  /// Draws into the bound framebuffer. An ImTextureID is the name of a GL_TEXTURE_2D. Leaves the viewport over the
  /// whole display, scissor test and blending off, depth test on, and its own program, vertex array and texture unit 0
  /// bound.
  void draw(const ImDrawData& data);

 private:
  const gl::Program& program_;
  gl::Texture font_;
  GLuint vertex_array_ = 0, vertices_ = 0, indices_ = 0;
};

}  // namespace fascia
