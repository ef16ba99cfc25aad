// Several grabs in the real window: one that stays, a second one moved by mouse and wheel, and the release of the first
// by its mark.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "base/file.h"
#include "sim/replay/replay.h"
#include "tests/support/window/window_fixture.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE(
    "two grabs in the window: the first stays, the second moves away with the wheel, the first is released by its "
    "mark") {
  const TemporaryFolder folder;
  const VirtualDisplay display(kWidth, kHeight);
  write_file(folder / "cube.json",
             nlohmann::json{{"fascia_scene", 1},
                            {"gravity", {0, 0, 0}},
                            {"bodies",
                             {{{"mesh", (source_dir() / "assets/meshes/cube.msh").string()},
                               {"materials", {{"default", {{"young_modulus", 2e4}, {"damping", 0.1}}}}},
                               {"fixed", {{{"lowest", 0.02}}}}}}},
                            {"camera", {{"eye", {0, 0.05, 0.4}}, {"target", {0, 0.05, 0}}, {"fov_deg", 30}}}}
                 .dump());
  FasciaWindow window({(folder / "cube.json").string(), "--stats", "stats.json", "--size", "1000x700"}, folder.path());
  const Screenshot rest = window.screenshot();

  INFO("Ctrl on release: the grab stays, and so does the pull");
  window.move(kMiddle - 40, kHeight / 2 - 60);
  window.press();
  window.move(kMiddle - 120, kHeight / 2 - 120);
  CHECK(eventually([&] { return changed_beside_panels(rest, window.screenshot()) > 0.01; }));
  window.key_down("ctrl");
  window.release();
  window.key_up("ctrl");
  const int mark_x = kMiddle - 120, mark_y = kHeight / 2 - 120;
  const Screenshot one = window.screenshot();
  CHECK(changed_beside_panels(rest, one) > 0.01);

  INFO("a second grab, led away from the viewer by the wheel, stays by T");
  window.move(kMiddle + 60, kHeight / 2);
  window.press();
  window.move(kMiddle + 66, kHeight / 2);
  for (int i = 0; i < 10; ++i) window.click(4);
  Screenshot two;
  CHECK(eventually([&] { return changed_beside_panels(one, two = window.screenshot()) > 0.005; }));
  window.key("t");
  window.release();

  INFO("the right button on the first one's mark lets go of it");
  window.move(mark_x, mark_y);
  CHECK(eventually([&] {
    window.click(3);
    return changed_beside_panels(two, window.screenshot()) > 0.01;
  }));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  const auto stats = nlohmann::json::parse(read_file(folder / "stats.json"));
  CAPTURE(stats.at("grab_N").dump());
  const auto& grabs = stats.at("grab_N").at("hands");
  REQUIRE(grabs.size() == 1);
  CHECK(grabs[0].at("hand") == 1);
  const double away = -grabs[0].at("force")[2].get<double>();
  CHECK(away > 0);
  CHECK(away > std::abs(grabs[0].at("force")[0].get<double>()));
}

TEST_CASE(
    "grabs that stay continue through a comparison, whose sides both accept more of them, and Escape releases all") {
  const TemporaryFolder folder;
  const VirtualDisplay display(kWidth, kHeight);
  write_file(
      folder / "cube.json",
      nlohmann::json{
          {"fascia_scene", 1},
          {"gravity", {0, 0, 0}},
          {"bodies", {{{"mesh", (source_dir() / "assets/meshes/cube.msh").string()}, {"fixed", {{{"lowest", 0.02}}}}}}},
          {"camera", {{"eye", {0, 0.05, 0.4}}, {"target", {0, 0.05, 0}}, {"fov_deg", 30}}}}
          .dump());
  FasciaWindow window({(folder / "cube.json").string(), "--size", "1000x700"}, folder.path());
  std::filesystem::path session;
  const auto grabs = [&] {  // number of grabs that pull, from the current file of the newest session
    session.clear();
    for (const auto& entry : std::filesystem::directory_iterator(display.state() / "sessions"))
      session = std::max(session, entry.path());
    std::set<std::uint32_t> ids;
    for (const Input& input : read_replay(session).inputs)
      if (const auto* springs = std::get_if<GrabInput>(&input.change)) {
        ids.clear();
        for (const GrabSpring& spring : *springs) ids.insert(spring.grab);
      }
    return ids.size();
  };
  const auto pull_and_stay = [&](int x, int y, std::size_t expected) {
    window.move(x, y);
    window.press();
    window.move(x - 20, y - 40);
    CHECK(eventually([&] { return window.screenshot(), grabs() == expected; }));
    window.key("t");
    window.release();
    window.screenshot();
  };
  window.screenshot();
  pull_and_stay(kMiddle + 50, kHeight / 2 - 40, 1);
  window.key("b");
  window.screenshot();
  CHECK(grabs() == 1);
  const int width = (kWidth - kPanels) / 2;
  pull_and_stay(kPanels + 3 * width / 2 - 20, kHeight / 2 + 10, 2);
  pull_and_stay(kPanels + width / 2 + 40, kHeight / 2 + 60, 3);
  window.key("b");
  window.screenshot();
  CHECK(grabs() == 3);
  window.key("Escape");
  CHECK(eventually([&] { return window.screenshot(), grabs() == 0; }));

  INFO("one that still follows the mouse lets go of both sides when the comparison ends");
  window.key("b");
  window.screenshot();
  window.move(kPanels + 3 * width / 2 - 20, kHeight / 2 + 10);
  window.press();
  window.move(kPanels + 3 * width / 2 - 40, kHeight / 2 - 30);
  CHECK(eventually([&] { return window.screenshot(), grabs() == 1; }));
  window.key("b");
  CHECK(eventually([&] { return window.screenshot(), grabs() == 0; }));
  window.release();
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  const CommandResult again = run_fascia({"run", "--replay", session.string()}, folder.path());
  CAPTURE(again.err);
  CHECK(again.err.find("fascia: the state is the recorded one to the bit") != std::string::npos);
}
