// What the log of a window's frames (app/window/parts/frame_log.h) says of a session with one grab.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/bench/timing.h"

namespace fascia {

struct LoggedFrame {
  double ended = 0;                        // [s] of the steady clock
  double elapsed_ms = 0;                   // since the previous frame began
  std::map<std::string, double> parts_ms;  // by the names of the columns: "panels_ms", ...
  int steps = 0;
  double simulated_s = 0;
  bool fused = false;
  double x = 0, y = 0;  // the pointer, as far as the frame knew it
};

/// Throws Error for another file.
std::vector<LoggedFrame> read_frame_log(const std::filesystem::path& path);

/// Where a pointer was put, and when [s].
struct PointerPut {
  double at = 0, x = 0, y = 0;
};

/// One session: the program was started, the tissue was grabbed, dragged along `puts` and let go [s].
struct WindowSession {
  double started = 0, pressed = 0, released = 0;
  std::vector<PointerPut> puts;
  std::vector<LoggedFrame> frames;
};

struct WindowFigures {
  double first_picture_s = 0;
  double longest_before_ms = 0;   // frame after the first picture, before the grab
  double longest_grabbed_ms = 0;  // frame from the grab on
  double fused_s = 0;             // from the first picture until the kernels were fused; negative: never
  // While the tissue is dragged, from a second after the grab on:
  double share = 0;  // of real time
  double pictures_per_s = 0;
  Spread frame_ms;
  Spread latency_ms;  // from a place of the mouse to the end of the first frame with it or a later one
  double steps_per_frame = 0;
  double step_ms = 0;
  std::map<std::string, double> parts_ms;  // medians per frame
};

/// Throws Error for a session without frames while the tissue was dragged.
WindowFigures figures_of(const WindowSession& session);

}  // namespace fascia
