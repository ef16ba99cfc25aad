// Data that the objects of the window share: the open session, the picture it is drawn on, the window's state and the
// message. None of these objects knows the window.
#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "app/session/framing.h"
#include "app/session/session.h"
#include "app/state/window_state.h"
#include "app/window/brush/lasso.h"
#include "app/window/brush/stroke.h"
#include "app/window/parts/instrument_hand.h"
#include "app/window/parts/messages.h"
#include "app/window/parts/mouse_tool.h"
#include "app/window/parts/real_time_clock.h"
#include "sim/output/run_provenance.h"

namespace fascia {

struct Stage {
  std::string command_line;  // as typed, for provenance
  std::unique_ptr<Session> session = nullptr;
  std::unique_ptr<Framebuffer> framebuffer = nullptr;  // the window's picture; none before its first frame
  WindowState state = {};
  Messages messages = {};
  MouseTool mouse = {};
  InstrumentHand hand = {};
  Stroke stroke = {};
  Lasso lasso = {};
  Pacing pacing = {};
  bool diagnose = true;  // the state has changed since the last diagnostics

  Simulation& simulation() const { return session->simulation; }
  Scene scene_now() const;  // with the current materials and camera
  /// scene_now() with grabs that stay, and with what is known of its files or, `with_mesh`, with all of them. Throws
  /// Error.
  Scene scene_to_save(bool with_mesh);
  Provenance provenance() const;
  void give_up_brush();      // an action of the brush that is under way does nothing
  int panels_cover() const;  // of the picture's width [pixels]
  Margins margins() const;   // of the window's picture

  /// Grabs that stay become grabs of the scene. `with_mesh`: the file carries its meshes and tables. Throws Error.
  void save(const std::filesystem::path& path, bool with_mesh);
  void export_state(const std::filesystem::path& path);
};

}  // namespace fascia
