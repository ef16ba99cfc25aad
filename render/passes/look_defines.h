// Variants of the drawing shaders that a look needs. Every flag is always defined, 0 or 1.
#pragma once
#include "gl/shader_source.h"
#include "render/view/look.h"

namespace fascia {

inline const char* flag(bool on) { return on ? "1" : "0"; }

inline gl::Defines backdrop_defines(const Look& look) {
  return {{"BACKDROP_WHITE", flag(look.backdrop == Backdrop::white)},
          {"BACKDROP_BLACK", flag(look.backdrop == Backdrop::black)},
          {"BACKDROP_TRANSPARENT", flag(look.backdrop == Backdrop::transparent)}};
}

/// What the drawn triangles have, beside the look.
struct DrawnTriangles {
  int triangles = 1;      // per item of the region buffer
  bool cap = false;       // the cut of a section plane
  bool colored = false;   // corners have colors of their own, which are shown
  bool detailed = false;  // corners have rest positions
  bool paints = false;    // regions have paints of their own
};

/// For surface.frag and the shaders before it.
gl::Defines tissue_defines(const Look& look, const DrawnTriangles& drawn);
/// The same for the depth map of the light.
gl::Defines depth_defines(const Look& look);

}  // namespace fascia
