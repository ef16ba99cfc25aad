// Mouse, keys and dropped files of a GLFW window, in the order and at the place of their occurrence. At a low frame
// rate many of them occur between two pictures, and an ImGui frame can distinguish only one: it has the current place
// of the mouse and the keys that are down. So ImGui processes one frame per input, several for a picture, and the scene
// gets the same inputs.
#pragma once
#include <Eigen/Core>
#include <array>
#include <deque>
#include <filesystem>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace fascia {

struct InputEvent {
  enum class Kind { press, release, move, scroll, key, key_up, text, drop };
  Kind kind;
  int code = 0;                  // mouse button or key in GLFW's numbering; for text the character
  int mods = 0;                  // GLFW_MOD_ bits
  Eigen::Vector2d at{0, 0};      // mouse, in pixels of the picture
  Eigen::Vector2d scroll{0, 0};  // notches sideways and up
  std::vector<std::filesystem::path> files{};
};

class WindowInput {
 public:
  explicit WindowInput(GLFWwindow* window);  // sets the window's callbacks and user pointer
  ~WindowInput();
  WindowInput(const WindowInput&) = delete;
  WindowInput& operator=(const WindowInput&) = delete;
  static WindowInput& of(GLFWwindow* window);

  /// Call before ImGui's frame: gives it the next input. After a press it first gets some frames without input, in
  /// which the pressed item opens and takes the keyboard focus.
  void feed();
  bool waiting() const { return !waiting_.empty(); }  // for another feed()
  std::vector<InputEvent> take();                     // the events of feed() since the last call
  /// Removes the next input if it is a press of this key, and returns true then.
  bool take_key(int key);
  /// Discards pending inputs, except releases of keys and buttons.
  void discard();
  /// Whether the window has received any event since the last call: input, or a reason to redraw.
  bool take_wake() { return std::exchange(woken_, false) || waiting(); }

 private:
  void add(InputEvent event);
  void give(const InputEvent& event);  // to ImGui
  Eigen::Vector2d pixel(const Eigen::Vector2d& at) const;

  GLFWwindow* window_;
  Eigen::Vector2d at_{0, 0};          // in GLFW's screen coordinates
  Eigen::Vector2d given_at_{0, 0};    // in pixels, as last given to ImGui
  std::array<bool, 5> given_down_{};  // buttons, as last given to ImGui
  std::deque<InputEvent> waiting_;
  std::vector<InputEvent> given_;
  int settling_ = 0;  // frames until the next input
  bool woken_ = false;
};

}  // namespace fascia
