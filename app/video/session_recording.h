// Records a session to a replay file: every input when it acts, and the camera. The file grows during the session and
// can be replayed at any time, even if the process ends unexpectedly: it contains everything older than a second.
#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>

#include "sim/replay/replay.h"

namespace fascia {

/// Creates a file for a session, in the folder `sessions` of the user's state folder. All but the last few recordings
/// there are removed, except those of running processes. Empty if there is no home. Throws Error if that folder cannot
/// be created.
std::filesystem::path session_file();

class SessionRecording {
 public:
  /// `beginning`: scene, start and made_by. Throws Error.
  SessionRecording(std::filesystem::path path, Replay beginning);
  ~SessionRecording();  // removes a file without inputs
  SessionRecording(const SessionRecording&) = delete;
  SessionRecording& operator=(const SessionRecording&) = delete;

  void add(const Input& input);
  /// Records the view of the picture before step `steps`. Of several before one step the last counts.
  void look(long steps, const CameraSettings& camera, const DisplaySettings& display);
  /// Call once per frame, and at intervals while there are none: writes everything older than a second. Throws Error,
  /// once, if the disk is full; the recording then stops.
  void breathe(long steps);
  /// Ends the file for now, with the hash of the state after `steps` steps. Throws Error, as breathe does.
  void note_state(long steps, std::uint64_t hash);
  /// Includes the files of the scene in saved copies from now on. False if that is not possible
  /// (self_contained_if_possible).
  bool carry_files(std::vector<ReadFile>& read);
  /// Saves a copy, with the scene's paths relative to its folder. Throws Error, also if the session is not recorded
  /// completely.
  void save_as(const std::filesystem::path& path);

 private:
  using Clock = std::chrono::steady_clock;
  void write_look();
  void flush();

  std::filesystem::path path_;
  Replay beginning_;
  std::ofstream out_;
  bool failed_ = false, used_ = false;
  CameraSettings camera_;  // as written or waiting
  DisplaySettings display_;
  std::optional<long> looked_camera_, looked_display_;  // the steps before which they wait to be written
  bool seen_ = false;
  long noted_steps_ = 0;
  bool news_ = false;
  Clock::time_point flushed_;
};

}  // namespace fascia
