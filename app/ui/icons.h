// Buttons with a drawn icon instead of a text. The icons are strokes, so that they are sharp at every scale and need no
// font.
#pragma once
#include <string>

namespace fascia::ui {

enum class Icon {
  open,
  recent,
  examples,
  save,
  export_state,
  undo,
  redo,
  compare,
  help,
  play,
  pause,
  step,
  reset,
  screenshot,
  video,
  stop,
  recording,
  plots,
  brush
};

/// A square button of `side` pixels. `name` and `help` are its tooltip; with `lit` the action is in effect, and a
/// button that is not `usable` is dim and never pressed.
bool icon_button(Icon icon, const char* name, const std::string& help, float side, bool lit = false,
                 bool usable = true);

/// Icons in one row, as large as the row has room for: `count` buttons and `gaps` between groups of them.
class IconRow {
 public:
  IconRow(int count, int gaps);
  bool add(Icon icon, const char* name, const std::string& help, bool lit = false, bool usable = true);
  void gap();

 private:
  float side_, gap_;
  bool first_ = true, after_gap_ = false;
};

}  // namespace fascia::ui
