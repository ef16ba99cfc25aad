#include "app/bench/window/virtual_screen.h"

#include <filesystem>
#include <thread>

#include "base/error.h"

namespace fascia {
namespace {

constexpr int kFirstScreen = 90, kLastScreen = 190;

std::filesystem::path socket_of(int screen) { return "/tmp/.X11-unix/X" + std::to_string(screen); }

// The lowest number that no server has. Another program may take it at the same moment; Xvfb then ends at once.
std::string free_screen() {
  for (int screen = kFirstScreen; screen < kLastScreen; ++screen)
    if (!std::filesystem::exists(socket_of(screen)) &&
        !std::filesystem::exists("/tmp/.X" + std::to_string(screen) + "-lock"))
      return ":" + std::to_string(screen);
  throw Error("/tmp/.X11-unix", "has no free number for a screen", "expected one from 90 to 189");
}

SpawnedProgram started_server(const std::string& name, int width, int height) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
  SpawnedProgram server({"Xvfb", name, "-screen", "0", size, "-nolisten", "tcp", "-noreset"});
  constexpr int kPatience = 200;  // times 50 ms
  const std::filesystem::path socket = socket_of(std::stoi(name.substr(1)));
  for (int i = 0; i < kPatience && !std::filesystem::exists(socket) && !server.ended(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  if (server.ended() || !std::filesystem::exists(socket))
    throw Error("Xvfb " + name, "did not start", "expected a virtual screen of " + size);
  return server;
}

}  // namespace

VirtualScreen::VirtualScreen(int width, int height)
    : name_(free_screen()),
      server_(started_server(name_, width, height)),
      mouse_({"xdotool", "-"}, {{"DISPLAY", name_}}) {}

VirtualScreen::Clock::time_point VirtualScreen::carry_out(const std::string& command) {
  mouse_.write(command + "\n");
  if (mouse_.ended()) throw Error("xdotool", "has ended", "expected a hand at the mouse until the end");
  return Clock::now();
}

VirtualScreen::Clock::time_point VirtualScreen::move(int x, int y) {
  return carry_out("mousemove " + std::to_string(x) + " " + std::to_string(y));
}
VirtualScreen::Clock::time_point VirtualScreen::press() { return carry_out("mousedown 1"); }
VirtualScreen::Clock::time_point VirtualScreen::release() { return carry_out("mouseup 1"); }

}  // namespace fascia
