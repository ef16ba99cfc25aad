#include "app/window/tuning_history.h"

#include <imgui.h>

#include "app/session/reproduce.h"
#include "app/state/continued_session.h"
#include "base/error.h"
#include "sim/fit/tuned_scene.h"
#include "sim/grab/build_model.h"
#include "sim/scene/scene_scale.h"

namespace fascia {
namespace {

Scene with_materials(Scene scene, const std::vector<MaterialEntries>& entries) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    scene.bodies[b].material = entries[b].material;
    scene.bodies[b].region_materials = entries[b].region_materials;
  }
  return scene;
}

// Whether other regions have materials of their own in the scene than in the session: they take other kernels.
bool regions_differ(const Scene& scene, const Session& session) {
  const auto regions = [](const Scene& s) {
    std::vector<std::vector<std::string>> names;
    for (const Body& body : s.bodies) {
      names.emplace_back();
      for (const auto& entry : body.region_materials) names.back().push_back(entry.first);
    }
    return names;
  };
  return regions(scene) != regions(session.simulation.scene);
}

}  // namespace

void TuningHistory::session_began() {
  stage_.state.history.restart(tunables_of(*stage_.session, stage_.state.grab));
  opened_camera_ = stage_.scene_now().camera;
}

void TuningHistory::follow() {
  if (ImGui::IsAnyItemActive() || stage_.mouse.dragging()) return;  // the user still drags a slider or a section plane
  const Tunables now = tunables_of(sides_.tuned(), stage_.state.grab);
  if (sides_.tuned().simulation.repeating())
    stage_.state.history.accept(now);
  else
    stage_.state.history.follow(now);
}

void TuningHistory::go_to(std::size_t entries) {
  UndoHistory& history = stage_.state.history;
  const std::size_t before = history.done();
  // The values after the last entry in force. The values in between need not be set.
  std::optional<Tunables> wanted;
  while (history.done() > entries && history.can_undo()) wanted = history.undo();
  while (history.done() < entries && history.can_redo()) wanted = history.redo();
  if (!wanted) return;
  try {
    rebuild(*wanted);  // first: it takes another session
  } catch (...) {
    while (history.done() < before) history.redo();
    while (history.done() > before) history.undo();
    throw;
  }
  Session& session = sides_.tuned();
  const std::vector<std::string> names = session.simulation.model.material_names;
  const auto set = [&] { set_tunables(session, stage_.state.grab, *wanted); };
  if (const Scene scene = with_materials(session.simulation.scene, wanted->materials); regions_differ(scene, session))
    kernels_.change(scene, set);
  else
    set();
  history.accept(tunables_of(session, stage_.state.grab));
  if (session.simulation.model.material_names != names) materials_changed();
}

void TuningHistory::set_fixed(const FixedSets& fixed) {
  Tunables wanted = tunables_of(*stage_.session, stage_.state.grab);
  wanted.fixed = fixed;
  rebuild(wanted);
}

void TuningHistory::set_painting(const Painting& painting) {
  Tunables wanted = tunables_of(*stage_.session, stage_.state.grab);
  wanted.regions = painting.regions;
  wanted.materials = painting.materials;
  rebuild(wanted);
  stage_.state.brush.reveal = true;  // below the list of regions, which grew
}

void TuningHistory::set_elements(const ElementOrders& elements) {
  Tunables wanted = tunables_of(*stage_.session, stage_.state.grab);
  wanted.elements = elements;
  rebuild(wanted);
}

void TuningHistory::set_instruments(const std::vector<Instrument>& instruments) {
  Tunables wanted = tunables_of(*stage_.session, stage_.state.grab);
  wanted.instruments = instruments;
  rebuild(wanted);
}

// Another session for other fixed vertices, regions, elements or instruments, with the materials of the regions and a
// method that carries them.
void TuningHistory::rebuild(const Tunables& wanted) {
  const Scene& now = sides_.tuned().simulation.scene;
  if (wanted.fixed == fixed_of(now) && wanted.regions == painted_of(now) && wanted.elements == elements_of(now) &&
      wanted.instruments == now.tools.instruments)
    return;
  if (sides_.split())
    throw Error("Fixed vertices, regions, elements and instruments", "cannot change during a comparison",
                "close the comparison first (B)");
  Scene scene = stage_.scene_now();
  scene.solver = wanted.solver;
  scene.tools.instruments = wanted.instruments;
  scene = with_materials(std::move(scene), wanted.materials);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    Body& body = scene.bodies[b];
    body.fixed = wanted.fixed[b];
    body.regions = wanted.regions[b];
    body.elements = wanted.elements[b];
  }
  sides_.let_go();
  if (wanted.instruments == now.tools.instruments)
    stage_.hand.rest();
  else
    stage_.hand.pick(std::nullopt);  // tools may have other numbers
  // With the first region there are several materials, which take other kernels
  std::unique_ptr<Session> session =
      kernels_.make(scene, [&] { return continued_session(graphics_, *stage_.session, scene); });
  recording_.begin_anew_around([&] { stage_.session = std::move(session); });
  kernels_.session_began(stage_.simulation());
  model_changed();
}

void TuningHistory::set_values(const std::vector<Estimate>& found) {
  std::vector<std::pair<std::string, double>> values;
  for (const Estimate& estimate : found) values.emplace_back(estimate.key, estimate.value);
  Session& session = sides_.tuned();
  const Scene scene = with_values(stage_.scene_now(), values);
  Tunables wanted = tunables_of(session, stage_.state.grab);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    wanted.materials[b] = {scene.bodies[b].material, scene.bodies[b].region_materials};
  set_tunables(session, stage_.state.grab, wanted);
}

void TuningHistory::set_materials(const std::vector<MaterialEntries>& entries) {
  Session& session = sides_.tuned();
  kernels_.change(with_materials(session.simulation.scene, entries), [&] { session.set_material_entries(entries); });
  materials_changed();
}

// The number of materials may have changed.
void TuningHistory::materials_changed() {
  Session& session = sides_.tuned();
  session.forget_errors();
  kernels_.session_began(session.simulation);
  model_changed();
  // With other regions the open session has another scene, so a new recording begins.
  if (&session == stage_.session.get()) recording_.begin_anew_around([] {});
}

void TuningHistory::model_changed() {
  const Simulation& simulation = sides_.tuned().simulation;
  stage_.state.convergence.forget();
  stage_.state.facts = SceneFacts(simulation.scene, simulation.model);
  stage_.pacing.restart();
  stage_.diagnose = true;
}

Opened TuningHistory::rescaled(double factor) const {
  Scene scene = scene_to_reproduce();
  scale_lengths(scene, factor);
  Model model = build_model(scene);
  return {std::move(scene), std::nullopt, std::move(model)};
}

// A camera that was not moved is the camera of the file, if any.
Scene TuningHistory::scene_to_reproduce() const {
  Scene scene = stage_.scene_now();
  if (scene.camera == opened_camera_) scene.camera = stage_.simulation().scene.camera;
  return scene;
}

void TuningHistory::copy_command() const {
  const std::string line = command_that_reproduces(scene_to_reproduce());
  ImGui::SetClipboardText(line.c_str());
  stage_.messages.say("Copied: " + line);
}

}  // namespace fascia
