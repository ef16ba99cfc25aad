// A screen without a monitor (Xvfb) and a hand at its mouse (xdotool), for measuring windows.
#pragma once
#include <chrono>
#include <string>

#include "app/system/spawned_program.h"

namespace fascia {

class VirtualScreen {
 public:
  using Clock = std::chrono::steady_clock;

  /// Throws Error if Xvfb or xdotool is missing.
  VirtualScreen(int width, int height);
  VirtualScreen(const VirtualScreen&) = delete;
  VirtualScreen& operator=(const VirtualScreen&) = delete;
  ~VirtualScreen();
  const std::string& name() const { return name_; }  // for DISPLAY

  /// Each returns when the command was passed on: the window gets the event about a millisecond later.
  Clock::time_point move(int x, int y);
  Clock::time_point press();
  Clock::time_point release();

 private:
  Clock::time_point carry_out(const std::string& command);

  SpawnedProgram server_;
  std::string name_;
  SpawnedProgram mouse_;
};

}  // namespace fascia
