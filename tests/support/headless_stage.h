// The shared objects of a window, without a window: one of the shipped scenes, a picture and ImGui.
#pragma once
#include <string>

#include "app/overlay/overlay.h"
#include "app/window/sides.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

namespace fascia::test {

struct HeadlessStage {
  static constexpr int kWidth = 1000, kHeight = 700;

  Graphics graphics = open_graphics(headless(), false);
  Overlay overlay{graphics};
  Stage stage{"fascia view"};
  Sides sides{graphics, stage};

  explicit HeadlessStage(const std::string& scene = "cube") {
    stage.session =
        std::make_unique<Session>(graphics, open_scene(source_dir() / "assets/scenes" / (scene + ".json")), false);
    stage.framebuffer = std::make_unique<Framebuffer>(kWidth, kHeight, 1);
    stage.state.facts = SceneFacts(stage.simulation().scene, stage.simulation().model);
    stage.state.history.restart(tunables_of(*stage.session, stage.state.grab));
    overlay.scale_to(kHeight);
  }

  /// Runs a request of a comparison, with an exchange that does nothing else.
  void compare(CompareAsk ask) {
    sides.carry_out(ask, [](const auto& change) { change(); });
  }
};

inline void set_iterations(Session& session, int iterations) {
  SolverSettings settings = session.simulation.scene.solver;
  settings.iterations = iterations;
  session.simulation.set_settings(settings);
}

inline int iterations_of(const Session& session) { return session.simulation.scene.solver.iterations; }

}  // namespace fascia::test
