// What the window does against loss: it keeps the scene as it was some seconds before, for a device that is lost and
// for a window that ends badly, and brings back tissue that came apart.
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
  /// An empty folder: nothing is kept on disk.
  Recovery(Stage& stage, Sides& sides, std::filesystem::path folder)
      : stage_(stage), sides_(sides), autosave_(std::move(folder)) {}

  void session_began();
  /// After the steps of a frame: where the state was lost, the tissue starts again where all was well, at rest and let
  /// go. What comes apart time after time would do so for ever: it pauses, and a replay of it is kept.
  void follow();
  void remember_now_and_then();  // the scene and its state. Throws what writing them threw
  void remember();
  void finish() { autosave_.finish(); }  // the window ends well
  /// Throws gl::ContextLost where the device is lost; it names the file that keeps the scene.
  void require_device() const;

  void look_for_left();  // once, when the window opens
  /// The file of a window that ended badly, until the user has said what to do with it.
  const std::optional<std::filesystem::path>& left() const { return left_; }
  void forget_left();
  void resumed(const std::filesystem::path& file);  // the scene of this file is open now
  /// The file of the window that last ended well; empty: none.
  std::filesystem::path last_session() const { return autosave_.last(); }

 private:
  void go_back(std::uint32_t lost);

  Stage& stage_;
  Sides& sides_;
  Autosave autosave_;
  std::shared_ptr<const Replay> remembered_;  // the scene as it was a few seconds ago
  std::string remembered_scene_;              // of it, as a file would say it
  long remembered_step_ = 0;                  // steps solved then
  std::optional<std::filesystem::path> left_;
  long divergences_ = 0;  // times in a row
  long diverged_at_ = 0;  // steps made when it last did
};

}  // namespace fascia
