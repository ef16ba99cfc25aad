// Mouse, keys and dropped files of a GLFW window, in the order and at the place where they happened: at a low frame rate a press,
// a drag and a release may all fall into one frame. ImGui gets the same events.
#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace fascia {

struct InputEvent {
  enum class Kind { press, release, move, scroll, key, drop };
  Kind kind;
  int code = 0;                  // mouse button or key, as GLFW numbers them
  int mods = 0;                  // GLFW_MOD_ bits
  Eigen::Vector2d at{0, 0};      // mouse, in pixels of the picture
  double scroll = 0;             // notches, up is positive
  std::vector<std::filesystem::path> files{};
};

class WindowInput {
 public:
  explicit WindowInput(GLFWwindow* window);  // sets the window's callbacks and user pointer
  ~WindowInput();
  WindowInput(const WindowInput&) = delete;
  WindowInput& operator=(const WindowInput&) = delete;

  std::vector<InputEvent> take();  // since the last call
  /// After ImGui's frame: it looks at keys once a frame, and the release of one that was pressed in the same frame waits until then.
  void end_frame();
  /// Whether anything at all has reached the window since the last call: input, or a reason to draw it anew.
  bool take_stir() { return std::exchange(stirred_, false); }

 private:
  struct KeyChange {
    int key, scancode, action, mods;
  };
  static WindowInput& of(GLFWwindow* window);
  void add(InputEvent event);
  void forward_key(const KeyChange& change);  // to ImGui

  GLFWwindow* window_;
  Eigen::Vector2d at_{0, 0};  // in GLFW's screen coordinates
  std::vector<InputEvent> events_;
  bool stirred_ = false;
  std::vector<KeyChange> pressed_, deferred_;  // since the last end_frame()
};

}  // namespace fascia
