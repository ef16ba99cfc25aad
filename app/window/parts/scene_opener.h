// Makes sessions from files. The window stays responsive, shows a progress bar if opening takes long, and the user can
// cancel. The open session is not touched: if a new one cannot be made, nothing changes.
#pragma once
#include <filesystem>
#include <future>
#include <memory>
#include <vector>

#include "app/overlay/overlay.h"
#include "app/session/open_input.h"
#include "app/session/session.h"
#include "app/window/parts/kernel_switch.h"
#include "app/window/parts/opening_screen.h"

namespace fascia {

/// All functions throw Error, and Cancelled if the user cancels.
class SceneOpener {
 public:
  /// `reference` selects the double-precision solver, `kernels` chooses the kernels of a session.
  SceneOpener(Graphics& graphics, Overlay& overlay, bool reference, const KernelSwitch& kernels)
      : graphics_(graphics), overlay_(overlay), reference_(reference), kernels_(kernels) {}

  std::unique_ptr<Session> open(const std::filesystem::path& path, const std::vector<std::string>& sets = {});
  /// The scene of an autosaved file (autosave.h), in the saved state.
  std::unique_ptr<Session> resume(const std::filesystem::path& path);
  /// From a scene that was read.
  std::unique_ptr<Session> make(Opened opened);

 private:
  Opened read(const std::filesystem::path& path, const std::vector<std::string>& sets, OpeningScreen& screen);
  std::unique_ptr<Session> make(Opened& opened, OpeningScreen& screen, double share_done);

  Graphics& graphics_;
  Overlay& overlay_;
  bool reference_;
  const KernelSwitch& kernels_;
  std::vector<std::future<Opened>> given_up_;  // cancelled readings, which end at their next report
};

}  // namespace fascia
