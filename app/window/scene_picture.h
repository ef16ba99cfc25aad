// The picture of the window and those of its videos: the scene, or both sides of a comparison, with the color bar and
// what marks places of them.
#pragma once
#include <functional>
#include <vector>

#include "app/overlay/overlay.h"
#include "app/window/observer.h"
#include "app/window/parts/hover.h"
#include "gl/timer.h"

namespace fascia {

class ScenePicture {
 public:
  /// `samples` of a pixel; 0: as many as suit the device.
  ScenePicture(Graphics& graphics, Overlay& overlay, Stage& stage, Sides& sides, const Observer& observer, int samples);

  /// The window's picture gets the size of the window. False: nothing to draw on, the window is minimised.
  bool update();
  void draw();
  /// The same frame on a picture of another size, with or without the panels.
  void draw_onto(Framebuffer& canvas, bool panels);
  void frame_bodies();  // the camera, beside what covers the picture

 private:
  /// Where a scene is drawn: a list has `scale` pixels in a unit; the tissue stands beside `left` pixels of panels; and
  /// whether it is drawn alone, without windows over it.
  struct Canvas {
    Framebuffer& picture;
    float scale;
    int left;
    bool alone;
  };
  void draw_scene(const Canvas& canvas);
  /// `drawn`: SplitView::draw.
  void draw_comparison(SplitView& split, const Canvas& canvas,
                       const std::function<void(std::size_t, const Framebuffer&)>& drawn = {});
  void draw_ring(const MarkArea& area, const Session& session) const;
  Margins margins_of(const Canvas& canvas) const;
  std::vector<Box> covered(const Canvas& canvas) const;  // what else is drawn over it

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
