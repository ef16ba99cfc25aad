// The picture of the window and those of its videos: the scene, or both sides of a comparison, with the color bar and
// markers in the scene.
#pragma once
#include <functional>
#include <vector>

#include "app/overlay/overlay.h"
#include "app/window/observer.h"
#include "app/window/parts/hover.h"
#include "gl/timing/timer.h"

namespace fascia {

class ScenePicture {
 public:
  /// `samples` per pixel; 0 selects the number by the device.
  ScenePicture(Graphics& graphics, Overlay& overlay, Stage& stage, Sides& sides, const Observer& observer, int samples);

  /// Resizes the picture to the window. Returns false if the window is minimized and there is nothing to draw on.
  bool update();
  /// `level` of Governor.
  void draw(int level);
  /// The same frame on a picture of another size, in the quality of still pictures, with or without the panels.
  void draw_onto(Framebuffer& canvas, bool panels);
  bool full() const;    // whether the last frame had the quality of still pictures
  Image still();        // the last frame with its panels, in the quality of still pictures
  void frame_bodies();  // places the camera so that the bodies are seen beside the panels
  /// Places it as when the scene was opened, if the middle of a tool of the model is not in the picture.
  void show_tool(std::size_t tool);

 private:
  /// Where a scene is drawn: `scale` is the number of pixels per unit of a draw list, `left` the width of the panels
  /// beside the tissue [pixels], and `alone` means without windows over the scene.
  struct Canvas {
    Framebuffer& picture;
    float scale;
    int left;
    bool alone;
  };
  void draw_scene(const Canvas& canvas);
  void set_quality(const Quality& quality);
  /// `drawn`: SplitView::draw.
  void draw_comparison(SplitView& split, const Canvas& canvas,
                       const std::function<void(std::size_t, const Framebuffer&)>& drawn = {});
  bool shows_pointer(const Framebuffer& picture) const;
  void draw_ring(const MarkArea& area, const Session& session) const;
  void draw_instruments(const MarkArea& area, const Session& session, const std::vector<ToolLoad>& loads,
                        LabelPlaces& places) const;
  Margins margins_of(const Canvas& canvas) const;
  MarkArea beside_docks(const MarkArea& area, const Canvas& canvas) const;
  std::vector<Box> covered(const Canvas& canvas) const;  // by other drawings

  Graphics& graphics_;
  Overlay& overlay_;
  Stage& stage_;
  Sides& sides_;
  const Observer& observer_;
  Hover hover_;
  gl::Timer timer_;
  int samples_;
};

}  // namespace fascia
