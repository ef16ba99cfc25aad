// Undo, redo and the comparison of two settings in the real window, by mouse and keys.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "sim/grab/build_model.h"
#include "sim/replay/replay.h"
#include "tests/support/window/window_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

std::string tuned_cube() {
  return nlohmann::json{{"fascia_scene", 1},
                        {"title", "Test cube"},
                        {"gravity", {0, 0, 0}},
                        {"bodies",
                         {{{"name", "cube"},
                           {"mesh", (source_dir() / "assets/meshes/cube.msh").string()},
                           {"materials", {{"default", {{"young_modulus", 2e4}, {"damping", 0.1}}}}},
                           {"fixed", {{{"lowest", 0.02}}}}}}}}
      .dump(2);
}

bool is_accent(const Image& image, int x, int y) {
  const std::uint8_t* p = &image.rgba[4 * (static_cast<std::size_t>(y) * image.width + x)];
  return p[0] > 180 && p[1] > 80 && p[1] < 140 && p[2] > 60 && p[2] < 120;
}

// The center of the first slider's knob.
std::pair<int, int> first_knob(const Image& image) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 20; x < kPanels; ++x) {
      int length = 0;
      while (x + length < kPanels && is_accent(image, x + length, y)) ++length;
      if (length >= 4) return {x + length / 2, y + 5};
    }
  return {0, 0};
}

// Whether a line of the accent color goes from the top to the bottom, right of the panels.
bool divided(const Image& image) {
  for (int x = kPanels; x < image.width; ++x) {
    int rows = 0;
    for (int y = 0; y < image.height; y += 8) rows += is_accent(image, x, y);
    if (rows > image.height / 8 - 4) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("a drag of a slider is undone and redone by keys, and two settings are compared") {
  const TemporaryFolder folder;
  const VirtualDisplay display(kLargeWidth, kLargeHeight);
  write_file(folder / "cube.json", tuned_cube());
  FasciaWindow window(
      {(folder / "cube.json").string(), "--size", std::to_string(kLargeWidth) + "x" + std::to_string(kLargeHeight)},
      folder.path());
  const Screenshot rest = window.screenshot();
  CHECK(rest.young_modulus == 2e4);
  CHECK_FALSE(divided(rest.image));

  const auto [x, y] = first_knob(rest.image);
  REQUIRE(y > 0);
  window.move(x, y);
  window.press();
  window.move(x + 15, y);
  window.move(x + 30, y);
  Screenshot turned;
  CHECK(eventually([&] { return (turned = window.screenshot()).young_modulus > 5e4; }));
  window.release();
  turned = window.screenshot();

  INFO("one drag is one entry");
  CHECK(eventually([&] {
    window.key("ctrl+z");
    return window.screenshot().young_modulus == 2e4;
  }));
  CHECK(eventually([&] {
    window.key("ctrl+shift+z");
    return window.screenshot().young_modulus == turned.young_modulus;
  }));
  window.key("ctrl+z");
  CHECK(eventually([&] { return window.screenshot().young_modulus == 2e4; }));
  window.key("ctrl+y");
  CHECK(eventually([&] { return window.screenshot().young_modulus == turned.young_modulus; }));

  INFO("two sides, and one again");
  window.key("b");
  CHECK(eventually([&] { return divided(window.screenshot().image); }));
  window.key("b");
  CHECK(eventually([&] { return !divided(window.screenshot().image); }));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}

TEST_CASE("a session with swapped sides is replayed to the bit, even if R returns to the start of a replay") {
  const TemporaryFolder folder;
  const VirtualDisplay display(kLargeWidth, kLargeHeight);
  write_file(folder / "cube.json", tuned_cube());
  Replay kept{open_scene(folder / "cube.json"), std::nullopt, {}, 0};
  const Model model = build_model(kept.scene);
  kept.start = initial_state(model);
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < held.size(); ++v)
    if (!held[v]) kept.start->displacement[v] = {0.01, 0, 0};
  write_replay(folder / "kept.fascia", kept);
  FasciaWindow window(
      {(folder / "kept.fascia").string(), "--size", std::to_string(kLargeWidth) + "x" + std::to_string(kLargeHeight)},
      folder.path());
  window.screenshot();
  std::filesystem::path session;
  const auto begins_at = [&] {  // of the newest recording; NaN while one replaces another
    session.clear();
    for (const auto& entry : std::filesystem::directory_iterator(display.state() / "sessions"))
      session = std::max(session, entry.path());
    try {
      const Replay replay = read_replay(session);
      return replay.start ? replay.start->time : 0;
    } catch (const Error&) {
      return std::nan("");
    }
  };
  window.key("b");
  CHECK(eventually([&] { return divided(window.screenshot().image); }));
  double began = begins_at();
  CHECK(began == 0);
  for (int swap = 0; swap < 2; ++swap) {
    window.move(128, 251);  // Swap
    window.press();
    window.pause();
    window.release();
    CHECK(eventually([&] { return begins_at() > began; }));
    began = begins_at();
    REQUIRE(began > 0);
  }
  window.key("r");
  CHECK(eventually([&] { return begins_at() == 0; }));
  window.screenshot();
  window.key("r");
  window.screenshot();
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  begins_at();
  REQUIRE_FALSE(read_replay(session).inputs.empty());
  const CommandResult again = run_fascia({"run", "--replay", session.string()}, folder.path());
  CAPTURE(again.err);
  CHECK(again.err.find("fascia: the state is the recorded one to the bit") != std::string::npos);
}

TEST_CASE(
    "a dragged section plane is undone in one step; a grab on the second side follows it, and the wheel zooms both") {
  const TemporaryFolder folder;
  const VirtualDisplay display(kLargeWidth, kLargeHeight);
  nlohmann::json scene = nlohmann::json::parse(tuned_cube());
  scene["display"] = {{"section", {{"normal", {1, 0, 0}}, {"offset", 0.02}}}};
  write_file(folder / "cube.json", scene.dump());
  FasciaWindow window(
      {(folder / "cube.json").string(), "--size", std::to_string(kLargeWidth) + "x" + std::to_string(kLargeHeight)},
      folder.path());
  CHECK(window.screenshot().section == 0.02);
  window.move(kLargeMiddle, 150);
  window.key_down("ctrl");
  window.press();
  for (int i = 1; i <= 6; ++i) {
    window.move(kLargeMiddle + 5 * i, 150);
    window.pause();  // frames between
  }
  window.release();
  window.key_up("ctrl");
  CHECK(eventually([&] { return window.screenshot().section > 0.02; }));
  window.key("ctrl+z");
  CHECK(eventually([&] { return window.screenshot().section == 0.02; }));

  window.key("b");
  CHECK(eventually([&] { return divided(window.screenshot().image); }));
  const int x = kPanels + 3 * (kLargeWidth - kPanels) / 4, y = kLargeHeight / 2;
  const Screenshot rest = window.screenshot();
  window.move(x, y);
  window.press();
  window.move(x + 60, y - 30);
  Screenshot pulled;
  CHECK(eventually([&] { return difference(rest.image, (pulled = window.screenshot()).image).share > 0.005; }));
  window.key("t");
  window.release();
  window.move(x, 120);  // beside the tissue
  CHECK(eventually([&] {
    window.click(5);
    return difference(pulled.image, window.screenshot().image).share > 0.05;
  }));
  window.key("b");
  CHECK(eventually([&] { return !divided(window.screenshot().image); }));
  const auto replays = [&] {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
      if (entry.path().extension() == ".fascia") found.push_back(entry.path());
    return found;
  };
  CHECK(eventually([&] {
    window.key("Escape");
    window.key("ctrl+r");
    window.pause();
    window.key("Return");
    window.pause();
    return !replays().empty();
  }));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  INFO("no grab is left on the remaining side");
  const Replay replay = read_replay(replays().front());
  const GrabInput* last = nullptr;
  for (const Input& input : replay.inputs)
    if (const auto* springs = std::get_if<GrabInput>(&input.change)) last = springs;
  REQUIRE(last);
  CHECK(last->empty());
}

TEST_CASE("Escape closes the panel Recording") {
  const TemporaryFolder folder;
  const VirtualDisplay display(kLargeWidth, kLargeHeight);
  write_file(folder / "cube.json", tuned_cube());
  FasciaWindow window(
      {(folder / "cube.json").string(), "--size", std::to_string(kLargeWidth) + "x" + std::to_string(kLargeHeight)},
      folder.path());
  const auto shown = [&] {
    const Image image = window.screenshot().image;
    const std::uint8_t* p = &image.rgba[4 * (262 * static_cast<std::size_t>(image.width) + 650)];  // beside its buttons
    return p[0] < 80 && p[1] < 80 && p[2] < 80;
  };
  CHECK_FALSE(shown());
  window.key("shift+v");
  CHECK(eventually(shown));
  window.key("Escape");
  CHECK(eventually([&] { return !shown(); }));
}
