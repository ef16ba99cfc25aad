// The panels as a whole: every widget has an explanation, and hints appear where they should and disappear when
// dismissed.
#include <catch2/catch.hpp>

#include "app/overlay/overlay.h"
#include "app/panels/panels.h"
#include "app/ui/audit.h"
#include "sim/grab/build_model.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("every widget of every panel has a text that explains it", "[panels]") {
  Graphics graphics = open_graphics(headless(), false);
  Overlay overlay(graphics);
  Framebuffer framebuffer(340, 400, 1);
  const std::vector<std::pair<const char*, SolverChoice>> shown = {
      {"inclusion", solver_choices().front()},
      {"probe", solver_choices().front()},
      {"cube", {Method::gauss_seidel, Acceleration::chebyshev}},
      {"cube", {Method::jacobi, Acceleration::anderson_positions}}};
  for (const auto& [name, pair] : shown) {
    const bool xpbd = pair.method != Method::two_level;  // whose methods carry laws of the strain alone
    Scene scene = open_scene(source_dir() / "assets/scenes" / (std::string(name) + ".json"),
                             xpbd ? std::vector<std::string>{"materials.default.model=signed_st_venant_kirchhoff"}
                                  : std::vector<std::string>{});
    scene.solver.method = pair.method;
    scene.solver.acceleration = pair.acceleration;
    scene.display.color = xpbd ? ColorBy::von_mises : ColorBy::recovered_von_mises;
    scene.display.range = Eigen::Vector2d(0, 1e4);
    Session session(graphics, scene, false);
    session.simulation.step();
    session.true_error.measure(session.simulation);  // for the bars of its errors
    session.measure_error();                         // for the peaks of the recovered stress
    CHECK(session.recovered.peak().has_value() == !xpbd);
    session.simulation.gpu()->request_diagnostics();
    WindowState state;
    state.facts = SceneFacts(session.simulation.scene, session.simulation.model);
    state.statistics.diagnostics = session.simulation.gpu()->take_diagnostics(true);
    state.statistics.measured = true;
    if (!session.simulation.model.tools.empty()) {
      state.instruments.picked = session.simulation.model.tools.size() - 1;
      state.instruments.readings.add(0, state.statistics.diagnostics->tool_loads);
    }
    state.history.restart(tunables_of(session, state.grab));
    scene.solver.iterations += 1;
    session.simulation.set_settings(scene.solver);
    state.history.follow(tunables_of(session, state.grab));
    Requests requests;
    session.draw(framebuffer);
    overlay.draw_headless(session, framebuffer, true, state.statistics.diagnostics, {},
                          [&] {  // folded or not, shown or not, in the window that ImGui has for what has none
                            for (const Panel& panel : panels()) panel.draw({session, state, requests});
                          });
  }
  CAPTURE(ui::unexplained());
  CHECK(ui::unexplained().empty());
}

TEST_CASE("the help in the tables is shown for every field") {
  Material material;
  visit_material(material, [](double, const char* name, const char*, double, double, bool, const char* help) {
    CAPTURE(name);
    CHECK(std::string(help).size() > 10);
  });
  SolverSettings settings;
  visit_settings(settings, [](auto, const char* name, const char*, auto, auto, bool, const char* help) {
    CAPTURE(name);
    CHECK(std::string(help).size() > 10);
  });
}

TEST_CASE("hints appear where they should", "[panels]") {
  CHECK_FALSE(locking_hint(0.45, true));
  CHECK(locking_hint(0.46, true));

  SolverSettings settings;
  Diagnostics diagnostics{};
  diagnostics.residual = 0.05;
  CHECK_FALSE(iterations_hint(settings, std::nullopt));
  CHECK_FALSE(iterations_hint(settings, diagnostics));
  diagnostics.residual = 0.4;
  REQUIRE(iterations_hint(settings, diagnostics));
  CHECK(iterations_hint(settings, diagnostics)->text == "Residual 0.4: too few iterations?");

  CHECK_FALSE(time_step_hint(settings));
  settings.time_step = 0.1;
  CHECK(time_step_hint(settings));
  settings.substeps = 10;
  CHECK_FALSE(time_step_hint(settings));

  const Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  Model model = build_model(scene);
  CHECK_FALSE(unit_hint(scene, model));
  for (Eigen::Vector3d& x : model.rest_positions) x *= 1000;
  REQUIRE(unit_hint(scene, model));
  CHECK(unit_hint(scene, model)->scale == 1e-3);
  for (Eigen::Vector3d& x : model.rest_positions) x *= 1e-6;
  REQUIRE(unit_hint(scene, model));
  CHECK(unit_hint(scene, model)->scale == 1e3);
}

TEST_CASE("hints at the mouse say what a drag does, also with an instrument in hand", "[panels]") {
  UserStore user("");
  Hints hints(user);
  const auto text = [&](bool in_hand) {
    std::string lines;
    for (const HintLine& line : hint_lines(hints, in_hand)) lines += std::string(line.text) + "\n";
    return lines;
  };
  CHECK(text(false) ==
        "F1: all keys, F2: examples\nDrag beside it to turn the view, wheel: zoom\nDrag the tissue to pull at it\n");
  CHECK(text(true) ==
        "F1: all keys, F2: examples\nAlt + drag beside the tissue to turn the view, Alt + wheel: zoom\n"
        "Drag to move the instrument, right drag to turn it\n");
  hints.done("grab");
  CHECK_THAT(text(true),
             Catch::Contains("Alt + drag") && Catch::EndsWith("Move a slider: the tissue changes at once\n"));
}
