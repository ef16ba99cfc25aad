// A virtual display with a fascia window on it, and hands: everything a test of the real window needs. Nothing waits
// for a fixed time; what is expected is polled for, with limits that only a hung program reaches.
#pragma once
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "render/target/image.h"
#include "tests/support/support.h"

namespace fascia::test {

/// Xvfb on a display number of its own; DISPLAY points to it as long as it lives, and so does a home of its own for
/// what windows remember of their user: one who knows the program and needs no hints.
class VirtualDisplay {
 public:
  VirtualDisplay(int width, int height);
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;
  /// What it shows, window and all: so many pictures in a row, ten in a second.
  std::vector<Image> watch(int frames) const;
  std::filesystem::path settings() const { return home_ / "config/fascia/settings.json"; }
  std::filesystem::path state() const { return home_ / "state/fascia"; }

 private:
  pid_t server_ = -1;
  std::string size_;  // "1000x700"
  TemporaryFolder home_;
};

/// A scene file: a cube of soft tissue on its clamped base, without gravity, in the middle of what the panels leave.
/// Nothing moves unless a grab moves it.
std::string cube_scene(const std::string& title, double young_modulus);

struct Screenshot {
  Image image;
  std::string title, moment;
  double young_modulus = 0;  // of the first body's default material [Pa]
  bool wireframe = false;
  double section = 0;  // offset of the section plane [m]
};

class FasciaWindow {
 public:
  /// Starts `fascia view` with the arguments in `folder` and waits until it shows a picture.
  FasciaWindow(std::vector<std::string> arguments, std::filesystem::path folder);
  ~FasciaWindow();
  FasciaWindow(const FasciaWindow&) = delete;
  FasciaWindow& operator=(const FasciaWindow&) = delete;

  void key(const std::string& name);                  // as xdotool names it: "p", "ctrl+o"
  void keys_at_once(std::vector<std::string> names);  // several of them in one frame
  void type(const std::string& text);
  void pause();             // as long as a person would, which proves nothing
  void move(int x, int y);  // in small steps from where the mouse is
  void press();             // left button
  void release();
  void key_down(const std::string& name);
  void key_up(const std::string& name);
  void click(int button);              // 3 right, 4 and 5 the wheel up and down
  void resize(int width, int height);  // as a window manager does
  Screenshot screenshot();             // through P
  /// The program stands still until go_on(): all that hands do meanwhile comes between two of its pictures.
  void hold();
  void go_on();
  bool running();
  void kill_at_once();               // as the system does: no chance to clean up
  double processor_seconds() const;  // that the program has used so far
  /// Exit code; the program must end by itself.
  int wait();
  std::string said() const;  // stdout and stderr

 private:
  std::filesystem::path folder_, log_;
  pid_t child_ = -1;
  std::string window_;
  int exit_code_ = -1;
  int x_ = 0, y_ = 0;
};

/// Polls until `condition` holds. False after a very long time.
bool eventually(const std::function<bool()>& condition);

/// The columns from `left` on: the picture without the panels.
Image right_part(const Image& image, int left);

}  // namespace fascia::test
