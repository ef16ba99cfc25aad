// An instrument in the real window: taken by Tab, pressed into tissue by the mouse, let go of; and the same again from
// the recording.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "sim/replay/replay.h"
#include "tests/support/window/window_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

// A ball over the cube, and a second one far behind it.
std::string scene_text() {
  const auto ball = [](const char* name, double z) {
    return nlohmann::json{{"name", name},
                          {"shape", {{"sphere", {{"radius", 0.015}}}}},
                          {"path", {{{"time", 0}, {"position", {0, 0.13, z}}}}}};
  };
  return nlohmann::json{{"fascia_scene", 1},
                        {"gravity", {0, 0, 0}},
                        {"bodies",
                         {{{"mesh", (source_dir() / "assets/meshes/cube.msh").string()},
                           {"materials", {{"default", {{"young_modulus", 2e4}, {"damping", 0.1}}}}},
                           {"fixed", {{{"lowest", 0.02}}}}}}},
                        {"instruments", {ball("ball", 0), ball("other", -0.5)}},
                        {"camera", {{"eye", {0, 0.05, 0.4}}, {"target", {0, 0.05, 0}}, {"fov_deg", 30}}}}
      .dump();
}

}  // namespace

TEST_CASE("an instrument taken by Tab is pressed into tissue by the mouse, which the recording repeats to the bit") {
  const TemporaryFolder folder;
  const VirtualDisplay display(1000, kHeight);
  write_file(folder / "cube.json", scene_text());
  FasciaWindow window({(folder / "cube.json").string(), "--stats", "stats.json", "--size", "1000x700"}, folder.path());
  const Screenshot rest = window.screenshot();
  window.key("Tab");
  const Screenshot taken = window.screenshot();
  INFO("the instrument in hand has another color, of some pixels");
  CHECK(changed_beside_panels(rest, taken) > 1e-4);
  CHECK(changed_beside_panels(rest, taken) < 0.05);

  window.move(kMiddle, kHeight / 4);
  window.press();
  window.move(kMiddle, kHeight / 4 + 130);  // by about 4 cm
  window.release();
  Screenshot pressed;
  CHECK(eventually([&] { return changed_beside_panels(taken, pressed = window.screenshot()) > 0.01; }));
  INFO("Escape lets go: the ball stays in the tissue, and a left drag grabs again");
  window.key("Escape");
  window.screenshot();
  window.key("ctrl+q");
  CHECK(window.wait() == 0);

  const auto contact = nlohmann::json::parse(read_file(folder / "stats.json")).at("contact");
  CAPTURE(contact.dump());
  CHECK(contact.at("ball").at("force_N")[1].get<double>() < -0.1);
  CHECK(contact.at("ball").at("points").get<int>() > 0);
  CHECK(contact.at("other").at("points") == 0);

  std::filesystem::path session;
  for (const auto& entry : std::filesystem::directory_iterator(display.state() / "sessions")) session = entry.path();
  const Replay replay = read_replay(session);
  std::size_t led = 0;
  for (const Input& input : replay.inputs)
    if (const auto* instrument = std::get_if<InstrumentInput>(&input.change)) {
      CHECK(instrument->name == "ball");
      ++led;
    }
  CHECK(led > 5);
  REQUIRE(replay.hash);
  const CommandResult again =
      run_command({FASCIA_BINARY, "render", "--replay", session.string(), "--hash", "--quiet", "--context", "egl"});
  CAPTURE(again.err);
  CHECK(again.out == "state " + hash_text(*replay.hash) + "\n");
}

TEST_CASE("the mouse still grabs tissue after the last instrument") {
  const TemporaryFolder folder;
  const VirtualDisplay display(1000, kHeight);
  write_file(folder / "cube.json", scene_text());
  FasciaWindow window({(folder / "cube.json").string(), "--stats", "stats.json", "--size", "1000x700"}, folder.path());
  window.screenshot();
  for (int i = 0; i < 3; ++i) window.key("Tab");
  const Screenshot rest = window.screenshot();
  window.move(kMiddle - 40, kHeight / 2 - 60);
  window.press();
  window.move(kMiddle - 120, kHeight / 2 - 120);
  CHECK(eventually([&] { return changed_beside_panels(rest, window.screenshot()) > 0.01; }));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  const auto stats = nlohmann::json::parse(read_file(folder / "stats.json"));
  CHECK(stats.at("contact").at("ball").at("points") == 0);
}

TEST_CASE("jaws close while G is held, and stay where it is released") {
  const TemporaryFolder folder;
  const VirtualDisplay display(1000, kHeight);
  auto scene = nlohmann::json::parse(scene_text());
  scene["instruments"] = {
      {{"name", "forceps"},
       {"jaws", {{"shape", {{"box", {{"center", {0.02, 0.002, 0}}, {"half_size", {0.02, 0.002, 0.004}}}}}}}},
       {"path", {{{"time", 0}, {"position", {0, 0.2, 0}}}}}}};
  write_file(folder / "cube.json", scene.dump());
  FasciaWindow window({(folder / "cube.json").string(), "--size", "1000x700"}, folder.path());
  window.screenshot();
  window.key("Tab");
  window.key_down("g");
  window.pause();
  window.key_up("g");
  window.pause();
  window.screenshot();
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  std::filesystem::path session;
  for (const auto& entry : std::filesystem::directory_iterator(display.state() / "sessions")) session = entry.path();
  double grip = 0, closing = 0;
  for (const Input& input : read_replay(session).inputs)
    if (const auto* instrument = std::get_if<InstrumentInput>(&input.change)) {
      closing = instrument->place.grip - grip;
      grip = instrument->place.grip;
    }
  CHECK(grip > 0.05);
  CHECK(grip < 0.95);
  CHECK(closing >= 0);
}
