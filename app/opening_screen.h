// What a window shows while a large scene is opened: its name and a bar.
#pragma once
#include <chrono>
#include <string>

#include "app/overlay.h"

namespace fascia {

class OpeningScreen {
 public:
  OpeningScreen(Graphics& graphics, Overlay& overlay, std::string name);
  /// A frame with the bar at `share`, if opening has taken long enough for anybody to wonder.
  void show(double share, const char* what);

 private:
  Graphics& graphics_;
  Overlay& overlay_;
  std::string name_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace fascia
