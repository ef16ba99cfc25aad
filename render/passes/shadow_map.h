// The key light: its direction, its depth map, and the share of it that reaches the ground.
#pragma once
#include <functional>

#include "gl/program.h"
#include "gl/texture.h"
#include "render/passes/vertex_array.h"
#include "render/view/frame_uniforms.h"
#include "render/view/look.h"

namespace fascia {

class ShadowMap {
 public:
  static constexpr int kSize = 1024;       // texels across the depth map
  static constexpr int kGroundSize = 128;  // texels across the map of light on the ground

  explicit ShadowMap(gl::ProgramCache& programs);
  ~ShadowMap();
  ShadowMap(const ShadowMap&) = delete;
  ShadowMap& operator=(const ShadowMap&) = delete;

  /// Sets the light's direction, its projection and the ground below it, for a scene of this center, radius and up.
  static void aim(const Look& look, FrameUniforms& frame);
  /// Calls `draw_depth` to draw the shadow casters, then blurs their shadow on the ground if `ground` is set.
  void draw(const std::function<void()>& draw_depth, bool ground) const;
  /// For sampler2DShadow, or if not `compared` for sampler2D.
  void bind_depth(GLuint unit, bool compared) const;
  void bind_ground_light(GLuint unit) const;  // for sampler2D
  /// Sizes of the maps and of the light, for programs that read the maps.
  static gl::Defines defines();

 private:
  const gl::Program &cover_program_, &light_program_;
  gl::Texture depth_, ground_cover_, ground_light_;
  GLuint depth_target_ = 0, cover_target_ = 0, light_target_ = 0;
  VertexArray no_vertices_;
};

}  // namespace fascia
