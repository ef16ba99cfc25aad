// Ground and background outside of shadows, kept as a picture with depth while neither the view nor the look changes.
// On software renderers drawing them takes a quarter of the time of a picture, and copying them is nearly free. The
// result is bitwise equal.
#pragma once
#include <array>
#include <optional>

#include "render/passes/ground.h"
#include "render/target/framebuffer.h"
#include "render/view/frame_uniforms.h"
#include "render/view/look.h"

namespace fascia {

class KeptStage {
 public:
  /// Begins the picture in `target` with the kept one and returns true. Returns false and leaves the target unchanged
  /// for the first picture of a view, and where keeping does not pay or is not exact: on GPUs, with several samples,
  /// with a transparent backdrop, and with ambient occlusion, which darkens the ground before the background is drawn.
  /// `frame` is bound as the uniform block; with `with_ground` the ground is in view.
  bool begin(const Ground& ground, const FrameUniforms& frame, const Look& look, bool with_ground,
             const Framebuffer& target);

 private:
  struct View {
    int width, height;
    bool ground, shadow;
    Backdrop backdrop;
    std::array<Eigen::Vector4f, 11> values;  // all uniforms that the stage's programs read
    bool operator==(const View&) const = default;
  };
  std::optional<View> last_;
  std::optional<Framebuffer> kept_;  // of last_
};

}  // namespace fascia
