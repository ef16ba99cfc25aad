// Videos and screenshots of the window.
#pragma once
#include "app/video/capture.h"
#include "app/window/scene_picture.h"

namespace fascia {

/// All that writes throws Error when ffmpeg or the disk fails.
class CaptureControl {
 public:
  CaptureControl(Stage& stage, ScenePicture& picture) : stage_(stage), picture_(picture) {}

  const VideoCapture& video() const { return video_; }
  void toggle_video();            // starts it, or ends it and says where it is
  void follow(double simulated);  // the video, after a frame that simulated so long [s]
  void finish();                  // the video that still runs
  void screenshot() const;

 private:
  Stage& stage_;
  ScenePicture& picture_;
  VideoCapture video_;
};

}  // namespace fascia
