// Handles mouse and keys: some actions run at once, the others become requests.
#pragma once
#include "app/ui/window_input.h"
#include "app/window/observer.h"
#include "app/window/recording_control.h"

namespace fascia {

class Controls {
 public:
  Controls(WindowInput& input, Stage& stage, Sides& sides, Observer& observer, RecordingControl& recording)
      : input_(input), stage_(stage), sides_(sides), observer_(observer), recording_(recording) {}

  void handle(Requests& requests);  // after ImGui::NewFrame, before the panels
  void note_panels();               // after the panels

 private:
  void press_button(const InputEvent& event, MouseTool::Picture picture);
  bool take_instrument(const InputEvent& event, MouseTool::Picture picture);
  bool scroll_instrument(const InputEvent& event);
  void take_over_replay();      // where the hand leads an instrument in it
  double brush_radius() const;  // [m]
  bool begin_brush(const InputEvent& event, BrushedPicture picture);
  void end_brush(BrushedPicture picture, Requests& requests);
  bool takes_key(int key) const;
  void press_key(int key, int mods, Requests& requests);
  void press_with_control(int key, bool shift, Requests& requests);

  WindowInput& input_;
  Stage& stage_;
  Sides& sides_;
  Observer& observer_;
  RecordingControl& recording_;
  int hand_button_ = 0;  // of the mouse, that moves the instrument
  // Items active or popups open when the last frame ended: ImGui closes them before handle() sees the key
  bool panels_take_escape_ = false;
};

}  // namespace fascia
