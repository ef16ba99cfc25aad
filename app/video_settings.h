// What a video of the window is to be.
#pragma once

namespace fascia {

enum class VideoKind { mp4, webm, pictures };

struct VideoSettings {
  VideoKind kind = VideoKind::mp4;
  int width = 0, height = 0;  // in pixels; 0: as the window is when it starts
  double fps = 60;
  bool panels = true;  // those of the window, where it shows any
};

}  // namespace fascia
