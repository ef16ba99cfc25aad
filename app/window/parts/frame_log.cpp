#include "app/window/parts/frame_log.h"

#include <cstdio>

#include "base/file.h"

namespace fascia {

void FrameLog::begin(double elapsed) {
  if (file_.empty()) return;
  rows_.push_back({{}, elapsed, {}, {}});
  last_ = Clock::now();
}

void FrameLog::end_of(Part part) {
  if (rows_.empty()) return;
  const Clock::time_point now = Clock::now();
  rows_.back().parts[static_cast<std::size_t>(part)] += std::chrono::duration<double, std::milli>(now - last_).count();
  last_ = now;
}

void FrameLog::end(const Shown& shown) {
  if (rows_.empty()) return;
  rows_.back().ended = Clock::now();
  rows_.back().shown = shown;
}

void FrameLog::write() const {
  if (file_.empty()) return;
  std::string text =
      "ended_s,elapsed_ms,panels_ms,steps_ms,scene_ms,overlay_ms,present_ms,steps,simulated_s,compiled,fused,"
      "quality,pointer_x,pointer_y\n";
  for (const Row& row : rows_) {
    const Shown& shown = row.shown;
    char line[320];
    std::snprintf(line, sizeof line, "%.6f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%d,%.6f,%d,%d,%d,%.1f,%.1f\n",
                  std::chrono::duration<double>(row.ended.time_since_epoch()).count(), 1000 * row.elapsed, row.parts[0],
                  row.parts[1], row.parts[2], row.parts[3], row.parts[4], shown.steps, shown.simulated, shown.compiled,
                  shown.fused, shown.quality, shown.pointer.x(), shown.pointer.y());
    text += line;
  }
  write_file(file_, text);
}

}  // namespace fascia
