// The surroundings of the scene: a ground plane with a grid that fades into the background, and the background itself.
#pragma once
#include "gl/program.h"
#include "render/passes/vertex_array.h"
#include "render/view/frame_uniforms.h"
#include "render/view/look.h"

namespace fascia {

struct GridScale {
  double spacing;  // of the fine lines [m]: 1, 2 or 5 times a power of ten
  int strong;      // number of fine lines per strong one
};
GridScale grid_scale(double scene_radius);

class Ground {
 public:
  explicit Ground(gl::ProgramCache& programs);
  static void lay(const Look& look, FrameUniforms& frame);
  void draw_unshadowed(const Look& look) const;  // all of it, or with shadows what lies beside the shadow map
  /// What lies under the shadow map, whose map of light on the ground is bound to texture unit 0. Nothing without
  /// shadows.
  void draw_shadowed(const Look& look) const;
  void draw_background(const Look& look) const;  // in pixels without geometry

 private:
  const gl::Program& program(const Look& look, bool shadow) const;

  gl::ProgramCache& programs_;
  VertexArray no_vertices_;
};

}  // namespace fascia
