// Protects the window against loss: keeps the scene of some seconds ago, for a lost device and for a window that
// crashes, and restores tissue that diverged.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/window/parts/autosave.h"
#include "app/window/sides.h"

namespace fascia {

class Recovery {
 public:
  /// With an empty folder nothing is kept on disk.
  Recovery(Stage& stage, Sides& sides, std::filesystem::path folder)
      : stage_(stage), sides_(sides), autosave_(std::move(folder)) {}

  void session_began();
  /// After the steps of a frame: if the state diverged, the tissue starts again from the last valid state, at rest and
  /// without grabs. Repeated divergence would never end, so it pauses the window and saves a replay.
  void follow();
  void remember_now_and_then();  // keeps the scene and its state. Throws errors of the previous write
  void remember();
  void finish() { autosave_.finish(); }  // the window closes normally
  /// Throws gl::ContextLost if the device is lost; the message names the file that keeps the scene.
  void require_device() const;

  void look_for_left();  // once, when the window opens
  /// The file of a window that crashed, until the user has decided what to do with the file.
  const std::optional<std::filesystem::path>& left() const { return left_; }
  void forget_left();
  void resumed(const std::filesystem::path& file);  // the scene of `file` is open
  /// The file of the last window that closed normally; empty without one.
  std::filesystem::path last_session() const { return autosave_.last(); }

 private:
  void go_back(std::uint32_t lost);

  Stage& stage_;
  Sides& sides_;
  Autosave autosave_;
  std::shared_ptr<const Replay> remembered_;  // the scene as it was a few seconds ago
  std::string remembered_scene_;              // text of the scene as in a file
  long remembered_step_ = 0;                  // solved steps at that time
  std::optional<std::filesystem::path> left_;
  long divergences_ = 0;  // consecutive
  long diverged_at_ = 0;  // number of steps at the last divergence
};

}  // namespace fascia
