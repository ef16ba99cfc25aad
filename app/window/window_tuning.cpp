// Changes to the open scene that are more than a slider: taking them back, regions with a material of their own,
// another unit, and the command line that brings them all back.
#include <imgui.h>

#include "app/session/reproduce.h"
#include "app/ui/units.h"
#include "app/window/opening_screen.h"
#include "app/window/window.h"
#include "sim/grab/build_model.h"
#include "sim/scene/scene_scale.h"

namespace fascia {

void Window::follow_tunables() {
  if (ImGui::IsAnyItemActive() || mouse_.dragging())
    return;  // a slider or a section plane that is held is not yet where it will be
  const Tunables now = tunables_of(tuned(), state_.grab);
  if (tuned().simulation.repeating())
    state_.history.accept(now);
  else
    state_.history.follow(now);
}

void Window::accept_tunables() {
  (state_.editing_b ? split_->history : state_.history).accept(tunables_of(*session_, state_.grab));
}

void Window::go_through_history(std::size_t entries) {
  UndoHistory& history = state_.history;
  // The values of the entry that is to be the last in force; those between need not be set.
  std::optional<Tunables> wanted;
  while (history.done() > entries && history.can_undo()) wanted = history.undo();
  while (history.done() < entries && history.can_redo()) wanted = history.redo();
  if (!wanted) return;
  const std::vector<std::string> names = tuned().simulation.model.material_names;
  set_tunables(tuned(), state_.grab, *wanted);
  history.accept(tunables_of(tuned(), state_.grab));
  if (tuned().simulation.model.material_names != names) materials_changed();
}

void Window::set_material_entries(const std::vector<MaterialEntries>& entries) {
  tuned().simulation.set_material_entries(entries);
  materials_changed();
}

void Window::materials_changed() {
  tuned().true_error.forget();
  state_.convergence.forget();
  state_.facts = SceneFacts(tuned().simulation.scene, tuned().simulation.model);
  pacing_.restart();
  diagnose_ = true;
  if (&tuned() != session_.get()) return;
  // With other regions it is another scene, whose recording begins here.
  leave_recorded_session();
  record_anew();
}

void Window::rescale(double factor) {
  Scene scene = scene_to_reproduce();
  scale_lengths(scene, factor);
  Model model = build_model(scene);
  Opened opened{std::move(scene), std::nullopt, std::move(model)};
  OpeningScreen screen(graphics_, overlay_, opened.scene.file.filename().string());
  take_over(make_session(opened, screen, 0));
  say("Scaled by " + engineering(factor, "") +
      ": the scene begins anew, and with it what can be undone. Ctrl+S saves it so");
}

// A camera that nobody moved is the file's, or none.
Scene Window::scene_to_reproduce() const {
  Scene scene = scene_now();
  if (scene.camera == opened_camera_) scene.camera = session_->simulation.scene.camera;
  return scene;
}

void Window::copy_command() {
  const std::string line = command_that_reproduces(scene_to_reproduce());
  ImGui::SetClipboardText(line.c_str());
  say("Copied: " + line);
}

}  // namespace fascia
