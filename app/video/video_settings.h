// What a video of the window is to be.
#pragma once

namespace fascia {

enum class VideoKind { mp4, webm, pictures };

struct VideoSettings {
  VideoKind kind = VideoKind::mp4;
  int width = 0, height = 0;  // in pixels; 0: as the window is when it starts
  double fps = 60;
  bool panels = false;  // those of the window, where it shows any

  struct Size {
    int width, height;
  };
  /// Encoders want even sizes; pictures have any.
  Size size_in(Size window) const {
    const Size wanted = width > 0 ? Size{width, height} : window;
    return kind == VideoKind::pictures ? wanted : Size{wanted.width & ~1, wanted.height & ~1};
  }
};

}  // namespace fascia
