#include "app/window/capture_control.h"

#include <cstdio>

#include "base/dated_name.h"

namespace fascia {

void CaptureControl::toggle_video() {
  if (!video_.running()) {
    video_.start(stage_.state.video, *stage_.framebuffer, stage_.provenance());
    return;
  }
  char text[64];
  std::snprintf(text, sizeof text, ", %.1f s", video_.seconds());
  std::string news = text;
  if (video_.dropped() > 0)
    news += ", " + std::to_string(video_.dropped()) + (video_.dropped() == 1 ? " frame" : " frames") + " repeated";
  const std::filesystem::path path = std::filesystem::absolute(video_.finish());
  stage_.messages.say(path.string() + news);
}

void CaptureControl::follow(double simulated) {
  if (!video_.running() || !video_.advance(simulated)) return;
  Framebuffer& canvas = video_.canvas(*stage_.framebuffer, stage_.state.show_panels, picture_.full());
  if (&canvas != stage_.framebuffer.get()) picture_.draw_onto(canvas, video_.settings().panels);
  video_.write(canvas);
}

void CaptureControl::finish() {
  if (video_.running()) video_.finish();
}

void CaptureControl::screenshot() const {
  const std::filesystem::path path = dated_name(".png");
  write_png(path, picture_.still(), stage_.provenance());
  stage_.messages.say(path.string());
}

}  // namespace fascia
