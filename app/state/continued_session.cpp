#include "app/state/continued_session.h"

#include <algorithm>
#include <utility>

#include "app/state/element_orders.h"
#include "sim/contact/carried_memory.h"

namespace fascia {

std::unique_ptr<Session> continued_session(Graphics& graphics, Session& old, Scene scene) {
  Model model = build_model(scene);
  if (const Model& before = old.simulation.model; before.plan) {  // it is still the mesh on its own
    model.plan = before.plan;
    model.notes.insert(model.notes.begin(), before.notes.front());
  }
  State state = with_elements(old.simulation.state(), old.simulation.model, model);
  state.contact = carried_memory(old.simulation.model, state.contact, model);
  for (const std::uint32_t v : model.fixed) {
    state.displacement[v].setZero();
    state.velocity[v].setZero();
  }
  std::erase_if(state.led, [&](const LedTool& led) {
    return std::none_of(scene.tools.instruments.begin(), scene.tools.instruments.end(),
                        [&](const Instrument& instrument) { return instrument.name == led.name; });
  });
  scene.camera = old.simulation.scene.camera;
  auto session =
      std::make_unique<Session>(graphics, std::move(scene), std::move(model), old.simulation.uses_reference());
  session->simulation.go_on_from(state);
  session->camera = old.camera;
  session->extent = old.extent;
  session->look.ground_height = old.look.ground_height;
  session->follow_true_error = old.follow_true_error;
  return session;
}

}  // namespace fascia
