// Measurements of a window and their destinations.
#include <catch2/catch.hpp>

#include "app/window/observer.h"
#include "base/file.h"
#include "tests/support/headless_stage.h"

using namespace fascia;
using namespace fascia::test;

namespace {

struct ObserverDesk : HeadlessStage {
  Observer observer{stage, sides};
  /// After a step, until the requested diagnostics are available.
  void measure() {
    sides.step();
    stage.diagnose = true;
    observer.read();
    for (int i = 0; i < 100 && stage.simulation().gpu()->diagnosing(); ++i) observer.read();
  }
};

}  // namespace

TEST_CASE("diagnostics are requested if something shows them, and go to the side that the panels show") {
  ObserverDesk desk;
  WindowState& state = desk.stage.state;
  state.show_panels = false;
  desk.measure();
  CHECK(desk.stage.diagnose);  // no request was made
  CHECK_FALSE(desk.observer.of_open_session());
  state.show_panels = true;
  desk.measure();
  CHECK_FALSE(desk.stage.diagnose);
  REQUIRE(desk.observer.of_open_session());
  REQUIRE(state.statistics.diagnostics);
  CHECK(desk.observer.residual() == desk.observer.of_open_session()->residual);
  CHECK(state.plots.history.all().empty());

  desk.compare(CompareAsk::open_or_close);
  set_iterations(*desk.sides.second(), 1);
  desk.measure();
  desk.measure();
  REQUIRE(state.statistics.diagnostics);
  CHECK(state.statistics.diagnostics->residual == desk.sides.split()->diagnostics()->residual);
}

TEST_CASE("plots get a sample of each measurement with its step, unless they are held") {
  ObserverDesk desk;
  Plots& plots = desk.stage.state.plots;
  plots.shown = true;
  desk.stage.state.statistics.steps = 41;
  desk.measure();
  REQUIRE(plots.history.all().size() == 1);
  CHECK(plots.history.all().back().step == 41);
  CHECK(plots.probe);
  plots.held = true;
  desk.measure();
  CHECK(plots.history.all().size() == 1);
}

TEST_CASE("measured curves are drawn in the plots, at their point") {
  ObserverDesk desk;
  Plots& plots = desk.stage.state.plots;
  plots.shown = true;
  desk.measure();
  const TemporaryFolder folder;
  const auto file = [&](const std::string& content) {
    write_file(folder / "a.csv", content);
    return folder / "a.csv";
  };
  desk.observer.show_measured(file("# Probe: vertex 5\ntime_ms,probe_y_mm,reaction_y_N\n0,1,2\n100,2,3\n"));
  CHECK(plots.probe == 5u);
  CHECK(plots.history.all().empty());
  REQUIRE(plots.measured.size() == 2);
  CHECK(plots.measured[1].probe.y() == Approx(2e-3));
  CHECK(plots.measured[1].reaction.y() == 3);
  CHECK(plots.measured_between(0.05, 0.06).size() == 2);
  CHECK_THROWS_WITH(desk.observer.show_measured(file("probe_y_mm\n1\n")),
                    Catch::Contains("has no curve over time that the plots show"));
  CHECK(plots.measured.size() == 2);
  plots.forget();
  CHECK(plots.measured.empty());
}

TEST_CASE("a fit to the measured curve runs until it has a result, fails or is canceled") {
  ObserverDesk desk;
  Plots& plots = desk.stage.state.plots;
  const TemporaryFolder folder;
  write_file(folder / "a.csv", "time_s,probe_y_m\n0.1,-0.001\n0.2,-0.002\n");
  desk.observer.show_measured(folder / "a.csv");
  CHECK_THROWS_WITH(desk.observer.start_fit(FASCIA_BINARY), Catch::Contains("has no free values"));
  plots.fit.keys = {"materials.default.young_modulus"};
  const auto wait = [&] {
    while (plots.fit.running) desk.observer.follow_fit();
  };
  desk.observer.start_fit(FASCIA_BINARY);
  CHECK(plots.fit.running);
  wait();
  CAPTURE(plots.fit.line);
  CHECK_FALSE(plots.fit.failed);
  REQUIRE(plots.fit.found.size() == 1);
  CHECK(plots.fit.found[0].low < plots.fit.found[0].value);

  desk.observer.start_fit("/bin/false");
  CHECK(plots.fit.found.empty());
  wait();
  CHECK(plots.fit.failed);
  CHECK(plots.fit.line == "The fit was ended");

  desk.observer.start_fit(FASCIA_BINARY);
  desk.observer.end_fit();
  CHECK_FALSE(plots.fit.running);
  CHECK_FALSE(desk.observer.follow_fit());
  CHECK(plots.fit.line == "canceled");
  plots.clear();
  CHECK(plots.measured.empty());
  CHECK(plots.fit.keys.empty());
}

TEST_CASE("a click chooses the vertex of the plots while the choice is open") {
  ObserverDesk desk;
  Plots& plots = desk.stage.state.plots;
  const Eigen::Vector2d middle(HeadlessStage::kWidth / 2, HeadlessStage::kHeight / 2);
  CHECK_FALSE(desk.observer.choose_probe(middle));
  plots.shown = plots.choosing = true;
  desk.measure();
  const std::optional<std::uint32_t> tip = plots.probe;
  CHECK(desk.observer.choose_probe(middle));
  CHECK_FALSE(plots.choosing);
  CHECK(plots.probe != tip);
  CHECK(plots.history.all().empty());
  CHECK(desk.stage.diagnose);
  CHECK_FALSE(desk.observer.choose_probe(middle));
}

TEST_CASE("the residual of the last step is available at the end, even if nothing showed it") {
  ObserverDesk desk;
  desk.sides.step();
  desk.observer.finish();
  CHECK(desk.observer.residual() > 0);
}
