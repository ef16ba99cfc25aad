// Several hands in the real window: one that stays, a second one moved by mouse and wheel, and the first let go of by its mark.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/file.h"
#include "sim/replay.h"
#include "tests/app/window_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr int kWidth = 1000, kHeight = 700, kPanels = 340;

double changed_share(const Screenshot& a, const Screenshot& b) {
  return difference(right_part(a.image, kPanels), right_part(b.image, kPanels)).share;
}

}  // namespace

TEST_CASE("two hands in the window: the first stays, the second goes away with the wheel, the first is let go of by its mark") {
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

  INFO("Ctrl on release: the hand stays, and so does the pull");
  window.move(kWidth / 2 - 40, kHeight / 2 - 60);
  window.press();
  window.move(kWidth / 2 - 120, kHeight / 2 - 120);
  CHECK(eventually([&] { return changed_share(rest, window.screenshot()) > 0.01; }));
  window.key_down("ctrl");
  window.release();
  window.key_up("ctrl");
  const int mark_x = kWidth / 2 - 120, mark_y = kHeight / 2 - 120;
  const Screenshot one = window.screenshot();
  CHECK(changed_share(rest, one) > 0.01);

  INFO("a second hand, led away from the viewer by the wheel, stays by T");
  window.move(kWidth / 2 + 60, kHeight / 2);
  window.press();
  window.move(kWidth / 2 + 66, kHeight / 2);
  for (int i = 0; i < 10; ++i) window.click(4);
  Screenshot two;
  CHECK(eventually([&] { return changed_share(one, two = window.screenshot()) > 0.005; }));
  window.key("t");
  window.release();

  INFO("the right button on the first one's mark lets go of it");
  window.move(mark_x, mark_y);
  CHECK(eventually([&] {
    window.click(3);
    return changed_share(two, window.screenshot()) > 0.01;
  }));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  const auto stats = nlohmann::json::parse(read_file(folder / "stats.json"));
  CAPTURE(stats.at("grab_N").dump());
  const auto& hands = stats.at("grab_N").at("hands");
  REQUIRE(hands.size() == 1);
  CHECK(hands[0].at("hand") == 1);
  const double away = -hands[0].at("force")[2].get<double>();
  CHECK(away > 0);
  CHECK(away > std::abs(hands[0].at("force")[0].get<double>()));
}

TEST_CASE("a hand that stays at side B of a comparison is let go of at both sides when the comparison ends") {
  const TemporaryFolder folder;
  const VirtualDisplay display(kWidth, kHeight);
  write_file(folder / "cube.json",
             nlohmann::json{{"fascia_scene", 1},
                            {"gravity", {0, 0, 0}},
                            {"bodies", {{{"mesh", (source_dir() / "assets/meshes/cube.msh").string()}, {"fixed", {{{"lowest", 0.02}}}}}}},
                            {"camera", {{"eye", {0, 0.05, 0.4}}, {"target", {0, 0.05, 0}}, {"fov_deg", 30}}}}
                 .dump());
  FasciaWindow window({(folder / "cube.json").string(), "--size", "1000x700"}, folder.path());
  const auto grabs = [&] {  // of the session, so far
    std::vector<Input> inputs;
    for (const auto& entry : std::filesystem::directory_iterator(display.state() / "sessions")) inputs = read_replay(entry.path()).inputs;
    std::erase_if(inputs, [](const Input& input) { return !std::holds_alternative<GrabInput>(input.change); });
    return inputs;
  };
  window.screenshot();
  window.key("b");
  window.screenshot();
  window.move(kPanels + 3 * (kWidth - kPanels) / 4, kHeight / 2 - 40);
  CHECK(eventually([&] {
    window.press();
    window.move(kPanels + 3 * (kWidth - kPanels) / 4 - 20, kHeight / 2 - 80);
    window.screenshot();
    return !grabs().empty();
  }));
  window.key("t");
  window.release();
  window.screenshot();
  REQUIRE_FALSE(std::get<GrabInput>(grabs().back().change).empty());
  window.key("b");
  CHECK(eventually([&] { return std::get<GrabInput>(grabs().back().change).empty(); }));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}
