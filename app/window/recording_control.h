// The recording of the open session, which begins with the session, and the replay that plays in the session: its
// camera, its display and its end.
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
  /// With `enabled` false no session is recorded.
  RecordingControl(Stage& stage, Sides& sides, bool enabled) : stage_(stage), sides_(sides), enabled_(enabled) {}

  void session_began();
  /// Once a frame, and at intervals while no frames are drawn. Throws Error if the disk is full.
  void follow();
  void end();  // completes the file of the session. Throws Error
  /// Throws Error, also if the session is not recorded.
  void save(const std::filesystem::path& path);

  /// Runs `change`, after which a recording cannot continue because the open session is a different one: the current
  /// recording ends before the change and a new one begins after it. Grabs that stay keep their hold.
  void begin_anew_around(const std::function<void()>& change);
  /// Runs `reset`, which returns to the start of the session.
  void reset_around(const std::function<void()>& reset);

  void follow_replay();  // applies its camera and display; ends it
  void take_over_replay() { end_replay("The replay ended; the tissue can be grabbed"); }

 private:
  void begin();
  void begin_replay();
  void end_replay(const std::string& news);  // `news` is shown unless a message is already shown
  void leave();

  Stage& stage_;
  Sides& sides_;
  bool enabled_;
  std::unique_ptr<SessionRecording> recording_;  // null: disabled, or without a folder
  long recorded_from_ = 0;                       // steps made before it
  bool begins_at_start_ = true;                  // the start that R returns to, not mid-session
  ReplayView replay_view_;
  std::optional<DisplaySettings> replayed_display_;
};

}  // namespace fascia
