#include "app/window/window_panels.h"

#include <imgui.h>

#include "app/panels/panels.h"
#include "app/system/user_files.h"
#include "app/ui/style.h"

namespace fascia {

WindowPanels::WindowPanels(Stage& stage, Sides& sides, const CaptureControl& capture, const Recovery& recovery,
                           const std::filesystem::path& data_dir, bool scripted)
    : stage_(stage),
      sides_(sides),
      capture_(capture),
      recovery_(recovery),
      scripted_(scripted),
      user_(scripted ? std::filesystem::path() : config_folder()),
      dialogs_(data_dir, user_),
      gallery_(data_dir),
      hints_(user_) {
  if (user_.now().light) ui::set_theme(ui::Theme::light);
  ui::set_interface_scale(static_cast<float>(user_.now().scale));
}

void WindowPanels::begin(bool greet) {
  dialogs_.opened(stage_.simulation().scene.file);
  if (!user_.warning().empty()) stage_.messages.say(user_.warning() + ". The window opens without it", true);
  dialogs_.set_last_session(recovery_.last_session());
  if (greet && !scripted_ && !user_.now().first_run_done && !config_folder().empty()) stage_.state.show_gallery = true;
}

void WindowPanels::ask(const Requests& requests) {
  const std::filesystem::path& file = stage_.simulation().scene.file;
  if (requests.open_dialog) dialogs_.ask_open(file);
  if (requests.recent) dialogs_.ask_recent();
  if (requests.export_dialog) dialogs_.ask_export(file);
  if (requests.save_dialog) dialogs_.ask_save(file);
  if (requests.save_replay_dialog) dialogs_.ask_replay();
}

void WindowPanels::draw(Requests& requests) {
  WindowState& state = stage_.state;
  const VideoCapture& video = capture_.video();
  state.statistics.speed = stage_.pacing.speed();
  state.statistics.keeps_pace = stage_.pacing.keeps_pace();
  state.recording = video.running();
  state.statistics.follow_inverted();
  state.grabs = stage_.mouse.grabs().all().size();
  state.instruments.picked = stage_.hand.picked();
  state.instruments.gap = stage_.hand.gap(sides_.held());
  state.instruments.waits = stage_.hand.waits();
  const Room room = room_beside_panels(state);
  const bool shown_alone = video.running() && !video.settings().panels;  // a video of the scene without panels
  if (!shown_alone) draw_notice(state, room);
  if (state.show_panels) {
    draw_panels({sides_.tuned(), state, requests});
    if (!scripted_ && !shown_alone && !sides_.split())
      draw_hints(hints_, state.instruments.picked.has_value(), room);  // a comparison shows its figures there
  }
  const Simulation& simulation = stage_.simulation();
  if (gallery_.draw(state, room.left, requests))
    user_.change([](UserSettings& settings) { settings.first_run_done = true; });
  if (state.plots.shown) draw_plots(simulation, state, requests);
  if (simulation.replaying()) draw_replay_badge(simulation, state, requests);
  if (state.show_recording) draw_recording_settings(state, requests);
  if (state.show_help) draw_help(state);
  dialogs_.draw(requests);
  if (recovery_.left()) draw_recovery(Autosave::name_in(*recovery_.left()), room, requests);
  follow_hints();
  if (const bool light = ui::theme() == ui::Theme::light; light != user_.now().light)
    user_.change([&](UserSettings& settings) { settings.light = light; });
  if (const double scale = ui::interface_scale(); scale != user_.now().scale)
    user_.change([&](UserSettings& settings) { settings.scale = scale; });
  stage_.messages.draw(requests.screenshot);  // a screenshot does not contain the news of the previous one
  if (video.running()) draw_recording_dot(video.seconds(), video.dropped());
}

// A hint is not shown again after its action was done once.
void WindowPanels::follow_hints() {
  const std::vector<Material>& materials = stage_.simulation().model.materials;
  if (stage_.mouse.grabs().following()) hints_.done("grab");
  if (stage_.mouse.orbiting()) hints_.done("orbit");
  if (stage_.state.show_help) hints_.done("help");
  // By a drag or by a typed number; a replay moves no widget, and an undo is no tuning.
  const bool by_user = ImGui::IsAnyItemActive() || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter));
  if (hints_.wanted("tune") && by_user && tuned_from_.size() == materials.size() && tuned_from_ != materials)
    hints_.done("tune");
  if (hints_.wanted("tune")) tuned_from_ = materials;
}

}  // namespace fascia
