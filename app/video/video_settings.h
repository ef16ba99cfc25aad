// The requested properties of a video of the window.
#pragma once

namespace fascia {

enum class VideoKind { mp4, webm, pictures };

struct VideoSettings {
  VideoKind kind = VideoKind::mp4;
  int width = 0, height = 0;  // in pixels; 0: the size of the window at the start
  double fps = 60;
  bool panels = false;  // includes the window's panels, if they are shown

  struct Size {
    int width, height;
  };
  /// Encoders require even sizes; pictures permit any.
  Size size_in(Size window) const {
    const Size wanted = width > 0 ? Size{width, height} : window;
    return kind == VideoKind::pictures ? wanted : Size{wanted.width & ~1, wanted.height & ~1};
  }
};

}  // namespace fascia
