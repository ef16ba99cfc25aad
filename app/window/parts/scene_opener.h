// Makes sessions of files. The window answers meanwhile, shows a bar while it takes long, and the user can give it up.
// A session that is open is not touched: where another one cannot be made, nothing has happened.
#pragma once
#include <filesystem>
#include <future>
#include <memory>
#include <vector>

#include "app/overlay/overlay.h"
#include "app/session/open_input.h"
#include "app/session/session.h"
#include "app/window/parts/opening_screen.h"

namespace fascia {

/// All of its functions throw Error, and Cancelled where the user gives it up.
class SceneOpener {
 public:
  /// `reference`: the double-precision solver. `single_kernels`: sessions begin with these (kernel_switch.h).
  SceneOpener(Graphics& graphics, Overlay& overlay, bool reference, bool single_kernels)
      : graphics_(graphics), overlay_(overlay), reference_(reference), single_kernels_(single_kernels) {}

  std::unique_ptr<Session> open(const std::filesystem::path& path);
  /// The scene that a window left (autosave.h), in the state that it had.
  std::unique_ptr<Session> resume(const std::filesystem::path& path);
  /// Of what has been read.
  std::unique_ptr<Session> make(Opened opened);

 private:
  Opened read(const std::filesystem::path& path, OpeningScreen& screen);
  std::unique_ptr<Session> make(Opened& opened, OpeningScreen& screen, double share_done);

  Graphics& graphics_;
  Overlay& overlay_;
  bool reference_, single_kernels_;
  std::vector<std::future<Opened>> given_up_;  // readings without a use, which end at their next report
};

}  // namespace fascia
