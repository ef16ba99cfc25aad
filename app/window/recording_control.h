// The recording of the session that is open, which begins by itself; and the replay that plays in it: its camera and
// display, and its end.
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/session/replay_view.h"
#include "app/video/session_recording.h"
#include "app/window/sides.h"

namespace fascia {

class RecordingControl {
 public:
  /// Not `enabled`: no session is recorded.
  RecordingControl(Stage& stage, Sides& sides, bool enabled) : stage_(stage), sides_(sides), enabled_(enabled) {}

  void session_began();
  /// Once a frame, and now and then while there are none. Throws Error when the disk is full.
  void follow();
  void end();  // the file has all of the session. Throws Error
  /// Throws Error, also where the session is not recorded.
  void save(const std::filesystem::path& path);

  /// Runs `change`, after which the session that is open is another one, as far as a recording can tell: the recording
  /// before it ends there, and another one begins. Grabs that stay hold on.
  void begin_anew_around(const std::function<void()>& change);
  /// Runs `reset`, which leads to where the session starts.
  void reset_around(const std::function<void()>& reset);

  void follow_replay();  // its camera and display; its end
  void take_over_replay() { end_replay("The replay ended; the tissue can be grabbed"); }

 private:
  void begin();
  void begin_replay();
  void end_replay(const std::string& news);  // said where nothing else is
  void leave();

  Stage& stage_;
  Sides& sides_;
  bool enabled_;
  std::unique_ptr<SessionRecording> recording_;  // none: there is no place for it
  long recorded_from_ = 0;                       // steps made before it
  bool begins_at_start_ = true;                  // where R goes, not in mid-session
  ReplayView replay_view_;
  std::optional<DisplaySettings> replayed_display_;
};

}  // namespace fascia
