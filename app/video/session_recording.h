// A session on its way into a replay file: every input as it acts, and where the camera was. The file grows while the
// session goes on and can be replayed at any moment, whatever becomes of this process: what is a second old is in it.
#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>

#include "sim/replay/replay.h"

namespace fascia {

/// A new file for a session, in the folder `sessions` of the user's state folder. Of those there all but the last few
/// are removed, though none of another process that is still there. Empty where there is no home. Throws Error when
/// that folder cannot be made.
std::filesystem::path session_file();

class SessionRecording {
 public:
  /// `beginning`: scene, start and made_by. Throws Error.
  SessionRecording(std::filesystem::path path, Replay beginning);
  ~SessionRecording();  // removes a file in which nobody did anything
  SessionRecording(const SessionRecording&) = delete;
  SessionRecording& operator=(const SessionRecording&) = delete;

  void add(const Input& input);
  /// What the picture before step `steps` shows. Of several before one step the last counts.
  void look(long steps, const CameraSettings& camera, const DisplaySettings& display);
  /// Once a frame, and now and then while there are none: brings to the file what is older than a second. Throws Error,
  /// once, when the disk is full; nothing is recorded from then on.
  void breathe(long steps);
  /// The file ends here for now, with the hash of the state after so many steps. Throws Error, as breathe does.
  void note_state(long steps, std::uint64_t hash);
  /// The scene of copies that are saved has its files in it from now on. False where that cannot be
  /// (self_contained_if_possible).
  bool carry_files(std::vector<ReadFile>& read);
  /// A copy, with the paths of its scene as seen from there. Throws Error, also where the session is not recorded to
  /// its end.
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
