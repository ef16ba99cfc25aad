// The screen shown while a large scene is opened: its name, a progress bar and a Cancel button.
#pragma once
#include <chrono>
#include <string>

#include "app/overlay/overlay.h"

namespace fascia {

/// Thrown if the user cancels an opening: the new session is discarded, and the open one stays as it was.
struct Cancelled {
  std::string name;  // of the file to open
};

class OpeningScreen {
 public:
  OpeningScreen(Graphics& graphics, Overlay& overlay, std::string name);
  ~OpeningScreen();  // discards the input made while the screen was shown
  OpeningScreen(const OpeningScreen&) = delete;
  OpeningScreen& operator=(const OpeningScreen&) = delete;
  /// Draws a frame with the bar at `share` if opening takes noticeably long. Throws Cancelled if Escape or Cancel was
  /// pressed, or the window closed.
  void show(double share, const char* what);

 private:
  bool draw(int width, int height, double share, const char* what);  // true: cancelled

  Graphics& graphics_;
  Overlay& overlay_;
  std::string name_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace fascia
