// The icons at the top of the column: files, undo, the clock, pictures, plots and tools. Keys do the same
// (app/window/controls.cpp).
#include "app/panels/panels.h"
#include "app/ui/icons.h"

namespace fascia {

using ui::Icon;

void toolbar(const PanelContext& context) {
  WindowState& state = context.state;
  Requests& requests = context.requests;
  const UndoHistory& history = state.history;

  ui::IconRow files(9, 3);
  requests.open_dialog |=
      files.add(Icon::open, "Open (Ctrl+O)", "A scene, a mesh or a replay; or drop it on the window");
  requests.recent |= files.add(Icon::recent, "Recent files (Ctrl+Shift+O)", "And the scene of the last window");
  if (files.add(Icon::examples, "Examples (F2)", "The shipped scenes", state.show_gallery))
    state.show_gallery = !state.show_gallery;
  files.gap();
  requests.save_dialog |= files.add(Icon::save, "Save (Ctrl+S)", "This scene with the values of the sliders, as JSON");
  requests.export_dialog |=
      files.add(Icon::export_state, "Export (Ctrl+E)", "The current state: .vtu, .csv, .msh, .obj or .inp");
  files.gap();
  if (files.add(Icon::undo, "Undo (Ctrl+Z)", history.can_undo() ? history.undone_next().text : "Nothing to undo", false,
                history.can_undo()))
    requests.history = history.done() - 1;
  if (files.add(Icon::redo, "Redo (Ctrl+Y)", history.can_redo() ? history.redone_next().text : "Nothing to redo", false,
                history.can_redo()))
    requests.history = history.done() + 1;
  files.gap();
  if (files.add(Icon::compare, "Compare (B)", "Two settings side by side under the same grab", state.comparing))
    requests.compare = CompareAsk::open_or_close;
  if (files.add(Icon::help, "Help (F1)", "Keys and mouse", state.show_help)) state.show_help = !state.show_help;

  ui::IconRow clock(9, 3);
  if (clock.add(state.paused ? Icon::play : Icon::pause, state.paused ? "Play (Space)" : "Pause (Space)",
                "Stops the clock, or lets it run", state.paused))
    state.paused = !state.paused;
  requests.step |= clock.add(Icon::step, "Step (.)", "One time step");
  requests.reset |= clock.add(Icon::reset, "Reset (R)", "Back to the start of the scene");
  clock.gap();
  requests.screenshot |= clock.add(Icon::screenshot, "Screenshot (P)",
                                   "A PNG in the current folder; hide the panels with H to leave them out");
  requests.video |=
      clock.add(state.recording ? Icon::stop : Icon::video, state.recording ? "Stop video (V)" : "Video (V)",
                "A video in the current folder", state.recording);
  if (clock.add(Icon::recording, "Recording (Shift+V)", "Video settings, and a replay of this session",
                state.show_recording))
    state.show_recording = !state.show_recording;
  clock.gap();
  const bool brushes = state.brush.in_hand();
  if (clock.add(Icon::brush, "Fix vertices", "A brush over the tissue; Brush on the tab Tissue paints regions, too",
                brushes, !state.comparing && !context.session.simulation.uses_reference())) {
    state.brush.brush = brushes ? Brush::off : Brush::fix;
    state.brush.reveal = true;
  }
  if (clock.add(Icon::plots, "Plots (F3)", "Curves over time", state.plots.shown))
    state.plots.shown = !state.plots.shown;
}

}  // namespace fascia
