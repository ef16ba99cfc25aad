// What is shown over the picture. Each panel reads the session and changes it at once; what must wait until the frame
// is done is asked for in Requests. Between ImGui::NewFrame and ImGui::Render; the size of the picture is ImGui's
// display size.
#pragma once
#include <string>

#include "app/panels/hints.h"
#include "app/session/session.h"
#include "app/state/window_state.h"

namespace fascia {

/// The column at the left: all panels below, one under the other.
void draw_panels(Session& session, WindowState& state, Requests& requests);

void scene_panel(const Session& session, WindowState& state, Requests& requests);
void material_panel(Simulation& simulation, WindowState& state, Requests& requests);
void solver_panel(Session& session, WindowState& state);
void compare_panel(const WindowState& state, Requests& requests);
void history_panel(const UndoHistory& history, Requests& requests);
void convergence_panel(const Simulation& simulation, Convergence& convergence);
void display_panel(Session& session);
void grab_panel(const Session& session, WindowState& state, Requests& requests);
void draw_plots(const Simulation& simulation, WindowState& state, Requests& requests);  // a window of its own, movable
bool shows_convergence(const Plots& plots);
/// Supports, weight, grabs and inertia, and a badge that tells whether they balance.
void balance_rows(const Simulation& simulation, const SceneFacts& facts, const Diagnostics& diagnostics);
void statistics_panel(Session& session, const WindowState& state);

/// Keys and mouse, one line each, over the picture; closes by its button or F1.
void draw_help(WindowState& state);

/// What the column at the left and docked plots leave of the picture's width [pixels].
struct Room {
  float left, right;
  float middle() const { return 0.5f * (left + right); }
  float width() const { return right - left; }
};
Room room_beside_panels(const WindowState& state);

/// Lines over the picture: what the mouse does (bottom), that time runs slow or stands (top).
void draw_hints(const Hints& hints, const Room& room);
/// Offers to go on with what a window left that ended badly; `scene`: its name.
void draw_recovery(const std::string& scene, Requests& requests);
void draw_notice(const WindowState& state, const Room& room);
/// A red dot: in front of everything and not part of pictures.
void draw_recording_dot(double seconds, long dropped);

/// While a replay plays, over the picture; and the small window that says what videos are to be.
void draw_replay_badge(const Simulation& simulation, WindowState& state, Requests& requests);
void draw_recording_settings(WindowState& state, Requests& requests);

/// A message at the top, an error in front of all else; true when it was closed by its button.
bool draw_message(const std::string& text, bool is_error);

/// Width of the column at the left in pixels.
float panel_width();
/// What of the picture's width it covers, with its margins.
float panel_space();

}  // namespace fascia
