// Panels and other drawings over the picture. A panel reads the session and changes it at once; work that must wait for
// the end of the frame is requested in Requests. Call these functions between ImGui::NewFrame and ImGui::Render; the
// size of the picture is ImGui's display size. Each panel of the column at the left has a file, a declaration here and
// a row of the table in panels.cpp.
#pragma once
#include <span>
#include <string>

#include "app/panels/hints.h"
#include "app/session/session.h"
#include "app/state/window_state.h"

namespace fascia {

struct PanelContext {
  Session& session;
  WindowState& state;
  Requests& requests;
};

struct Panel {
  const char* tab;                     // on which the panel is; null: above the tabs, always shown
  const char* title;                   // of the heading that folds the panel; null: no heading, always unfolded
  bool open_at_first;                  // unfolded
  bool (*shown)(const PanelContext&);  // null: always
  void (*draw)(const PanelContext&);
};

std::span<const Panel> panels();  // from top to bottom
/// The column at the left, with all of them.
void draw_panels(const PanelContext& context);

void scene_panel(const PanelContext& context);
void toolbar(const PanelContext& context);  // a part of the scene's panel
void compare_panel(const PanelContext& context);
void material_panel(const PanelContext& context);
void solver_panel(const PanelContext& context);
void convergence_panel(const PanelContext& context);
void display_panel(const PanelContext& context);
void statistics_panel(const PanelContext& context);
void grab_panel(const PanelContext& context);
void brush_panel(const PanelContext& context);
void instruments_panel(const PanelContext& context);
void history_panel(const PanelContext& context);

void draw_plots(const Simulation& simulation, WindowState& state, Requests& requests);  // a window of its own, movable
/// The part of the plots that fits values of the scene to the measured curves.
void fit_rows(const Simulation& simulation, FitPanel& fit, Requests& requests);
bool shows_convergence(const Plots& plots);
/// The content of the panel Convergence, which the plots show too.
void convergence_rows(const Simulation& simulation, Convergence& convergence);
/// Supports, weight, grabs and inertia, and a badge that shows whether they balance.
void balance_rows(const Simulation& simulation, const SceneFacts& facts, const Diagnostics& diagnostics);

/// Keys and mouse, one line each, over the picture; closes by its button or F1.
void draw_help(WindowState& state);

/// The parts of the picture that docked windows cover at the right and at the bottom [pixels].
struct Cover {
  float right, bottom;
};
Cover cover_of(const WindowState& state);

/// The part of the picture beside the column at the left, docked plots and the gallery [pixels].
struct Room {
  float left, right, bottom;
  float middle() const { return 0.5f * (left + right); }
  float width() const { return right - left; }
};
Room room_beside_panels(const WindowState& state);

/// Lines over the picture: the actions of the mouse (bottom); a notice of slow or paused time (top).
/// `in_hand`: a drag moves an instrument.
void draw_hints(const Hints& hints, bool in_hand, const Room& room);
/// Offers to restore the scene of a window that crashed; `scene` is its name.
void draw_recovery(const std::string& scene, const Room& room, Requests& requests);
void draw_notice(const WindowState& state, const Room& room);
/// A red dot, in front of everything and not part of pictures.
void draw_recording_dot(double seconds, long dropped);

/// The badge of a playing replay, over the picture, and the small window of video settings.
void draw_replay_badge(const Simulation& simulation, WindowState& state, Requests& requests);
void draw_recording_settings(WindowState& state, Requests& requests);

/// A message at the top, an error in front of everything else. Returns true if the message was closed by its button.
bool draw_message(const std::string& text, bool is_error);

/// Width of the column at the left in pixels.
float panel_width();
/// The part of the picture's width that the column covers, with its margins.
float panel_space();

}  // namespace fascia
