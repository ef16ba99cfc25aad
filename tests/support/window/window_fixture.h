// A virtual display with a fascia window, and simulated input: everything that a test of the real window needs. Nothing
// waits for a fixed time; expected states are polled, with time limits that only a hung program reaches.
#pragma once
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "render/target/image.h"
#include "tests/support/support.h"

namespace fascia::test {

/// The size of most windows [px]; slightly more than the width of the column of panels; the middle of the area beside
/// it.
constexpr int kWidth = 1000, kHeight = 700, kPanels = 340, kMiddle = (kPanels + kWidth) / 2;
/// Of windows whose panels need more room.
constexpr int kLargeWidth = 1280, kLargeHeight = 720, kLargeMiddle = (kPanels + kLargeWidth) / 2;

/// The arguments and a window of kWidth x kHeight.
std::vector<std::string> with_size(std::vector<std::string> arguments);

/// Xvfb on a separate display number; DISPLAY refers to it while it exists, and the home folder for the window's
/// settings is separate, too: that of an experienced user who needs no hints.
class VirtualDisplay {
 public:
  VirtualDisplay(int width, int height);
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;
  /// The content of the display, including the window: `frames` pictures in a row, ten per second.
  std::vector<Image> watch(int frames) const;
  std::filesystem::path settings() const { return home_ / "config/fascia/settings.json"; }
  std::filesystem::path state() const { return home_ / "state/fascia"; }

 private:
  pid_t server_ = -1;
  std::string size_;  // "1000x700"
  TemporaryFolder home_;
};

/// A scene file: a cube of soft tissue on its clamped base, without gravity, centered beside the panels. Only a grab
/// moves it.
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

  void key(const std::string& name);                  // in xdotool's notation: "p", "ctrl+o"
  void keys_at_once(std::vector<std::string> names);  // several keys in one frame
  void type(const std::string& text);
  void pause();             // as long as a user would; no test relies on its length
  void move(int x, int y);  // in small steps from the current position
  void press();             // left button
  void release();
  void key_down(const std::string& name);
  void key_up(const std::string& name);
  void click(int button);              // 3 right, 4 and 5 the wheel up and down
  void resize(int width, int height);  // as a window manager does
  Screenshot screenshot();             // taken by the key P
  /// Suspends the program until go_on(): all input in between arrives between two of its pictures.
  void hold();
  void go_on();
  bool running();
  void kill_at_once();               // with SIGKILL: no chance to clean up
  double processor_seconds() const;  // used by the program so far
  /// Returns the exit code; the program must end by itself.
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

/// The share of changed pixels beside the column of panels.
double changed_beside_panels(const Screenshot& from, const Screenshot& to);

}  // namespace fascia::test
