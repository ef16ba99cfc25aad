// Videos and screenshots of the window.
#pragma once
#include "app/video/capture.h"
#include "app/window/scene_picture.h"

namespace fascia {

/// Functions that write throw Error if ffmpeg or the disk fails.
class CaptureControl {
 public:
  CaptureControl(Stage& stage, ScenePicture& picture) : stage_(stage), picture_(picture) {}

  const VideoCapture& video() const { return video_; }
  void toggle_video();            // starts a video, or ends it and shows its path
  void follow(double simulated);  // adds a frame to the video after `simulated` seconds of simulation
  void finish();                  // ends a running video
  void screenshot() const;

 private:
  Stage& stage_;
  ScenePicture& picture_;
  VideoCapture video_;
};

}  // namespace fascia
