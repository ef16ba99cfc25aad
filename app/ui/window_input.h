// Mouse, keys and dropped files of a GLFW window, in the order and at the place where they happened. At a low frame
// rate many of them come between two pictures, and an ImGui frame can tell apart only one: it knows where the mouse and
// which keys are down at that moment. So ImGui makes as many frames for a picture as there are inputs, each of one
// input, and the scene gets the same inputs.
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
  int code = 0;                  // mouse button or key, as GLFW numbers them; of text the character
  int mods = 0;                  // GLFW_MOD_ bits
  Eigen::Vector2d at{0, 0};      // mouse, in pixels of the picture
  Eigen::Vector2d scroll{0, 0};  // notches to the side and up
  std::vector<std::filesystem::path> files{};
};

class WindowInput {
 public:
  explicit WindowInput(GLFWwindow* window);  // sets the window's callbacks and user pointer
  ~WindowInput();
  WindowInput(const WindowInput&) = delete;
  WindowInput& operator=(const WindowInput&) = delete;
  static WindowInput& of(GLFWwindow* window);

  /// Before ImGui's frame: gives it the next input. After a press it first gets some frames without any, in which what
  /// was pressed opens and takes the keyboard.
  void feed();
  bool waiting() const { return !waiting_.empty(); }  // for another feed()
  std::vector<InputEvent> take();                     // what feed() has given since the last call
  /// Takes the next input away if it is a press of this key: true.
  bool take_key(int key);
  /// Forgets what is waiting, but for keys and buttons that were let go.
  void discard();
  /// Whether anything at all has reached the window since the last call: input, or a reason to draw it anew.
  bool take_wake() { return std::exchange(woken_, false) || waiting(); }

 private:
  void add(InputEvent event);
  void give(const InputEvent& event);  // to ImGui
  Eigen::Vector2d pixel(const Eigen::Vector2d& at) const;

  GLFWwindow* window_;
  Eigen::Vector2d at_{0, 0};          // in GLFW's screen coordinates
  Eigen::Vector2d given_at_{0, 0};    // in pixels, as ImGui knows it
  std::array<bool, 5> given_down_{};  // buttons, as ImGui knows them
  std::deque<InputEvent> waiting_;
  std::vector<InputEvent> given_;
  int settling_ = 0;  // frames until the next input
  bool woken_ = false;
};

}  // namespace fascia
