#include "app/bench/window/virtual_screen.h"

#include "base/error.h"

namespace fascia {
namespace {

constexpr double kPatience = 20;  // [s]

SpawnedProgram started_server(int width, int height) {
  // The server itself finds a number that no other has, and writes it to its standard input when it can be used.
  return SpawnedProgram({"Xvfb", "-displayfd", "0", "-screen", "0",
                         std::to_string(width) + "x" + std::to_string(height) + "x24", "-nolisten", "tcp", "-noreset"});
}

std::string name_of(SpawnedProgram& server) {
  const std::string number = server.answered_line(kPatience);
  if (number.empty()) throw Error("Xvfb", "did not start", "expected a virtual screen");
  return ":" + number;
}

}  // namespace

VirtualScreen::VirtualScreen(int width, int height)
    : server_(started_server(width, height)), name_(name_of(server_)), mouse_({"xdotool", "-"}, {{"DISPLAY", name_}}) {}

VirtualScreen::~VirtualScreen() {
  server_.ask_to_end();  // a server that is killed leaves its socket behind
  server_.wait_for_end(kPatience);
}

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
