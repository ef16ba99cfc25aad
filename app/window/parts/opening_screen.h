// What a window shows while a large scene is opened: its name, a bar, and a way out.
#pragma once
#include <chrono>
#include <string>

#include "app/overlay/overlay.h"

namespace fascia {

/// Nobody waits any more: what was being made is given up, and whoever asked for it goes on as before.
struct Cancelled {
  std::string name;  // of what was being opened
};

class OpeningScreen {
 public:
  OpeningScreen(Graphics& graphics, Overlay& overlay, std::string name);
  ~OpeningScreen();  // what was pressed while it was shown is not for the scene
  OpeningScreen(const OpeningScreen&) = delete;
  OpeningScreen& operator=(const OpeningScreen&) = delete;
  /// A frame with the bar at `share`, if opening has taken long enough for anybody to wonder. Throws Cancelled when
  /// Escape or Cancel was pressed, or the window closed.
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
