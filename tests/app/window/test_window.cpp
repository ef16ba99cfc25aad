// The real window on a virtual display, operated through xdotool.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/session/open_input.h"
#include "app/system/user_files.h"
#include "app/window/window.h"
#include "base/file.h"
#include "sim/grab/build_model.h"
#include "sim/replay/replay.h"
#include "tests/support/window/window_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

struct SceneDesk {
  TemporaryFolder folder;
  VirtualDisplay display{kWidth, kHeight};
  std::string scene(const std::string& name, const std::string& text) const {
    write_file(folder / name, text);
    return (folder / name).string();
  }
};

// Without panels, hints and messages, which are at the edges.
Image scene_part(const Screenshot& shot) {
  constexpr int kEdge = 60;
  Image part = right_part(shot.image, kPanels);
  const auto row = static_cast<std::ptrdiff_t>(4) * part.width;
  part.height -= 2 * kEdge;
  part.rgba = {part.rgba.begin() + kEdge * row, part.rgba.begin() + (kEdge + part.height) * row};
  return part;
}

double changed_share(const Screenshot& a, const Screenshot& b) {
  return difference(scene_part(a), scene_part(b)).share;
}

// Moves the pointer over the panels, where the window draws no ring around it, and waits for two equal pictures in a
// row, since reactions to the pointer or to the size of the panels come a frame late.
Screenshot undisturbed(FasciaWindow& window) {
  window.move(8, 8);
  Screenshot last = window.screenshot();
  REQUIRE(eventually([&] {
    const Screenshot before = std::exchange(last, window.screenshot());
    return difference(before.image, last.image).share < 1e-3 && changed_share(before, last) == 0;
  }));
  return last;
}

// Center of the first slider's knob in the panels: the accent color (see ui_style.cpp), in the uppermost rows that
// contain it.
struct Spot {
  int x = 0, y = 0;
};
Spot first_slider(const Image& image) {
  const auto is_knob = [&](int x, int y) {
    const std::uint8_t* p = &image.rgba[4 * (static_cast<std::size_t>(y) * image.width + x)];
    return p[0] > 180 && p[1] > 80 && p[1] < 140 && p[2] > 60 && p[2] < 120;
  };
  for (int y = 0; y < image.height; ++y)
    for (int x = 20; x < kPanels; ++x) {
      int length = 0;
      while (x + length < kPanels && is_knob(x + length, y)) ++length;
      if (length >= 4) return {x + length / 2, y + 5};
    }
  return {};
}

double farthest_vertex(const std::filesystem::path& csv, const std::filesystem::path& rest_csv) {
  std::ifstream now(csv), rest(rest_csv);
  std::string a, b;
  double farthest = 0;
  while (std::getline(now, a) && std::getline(rest, b)) {
    double index = 0, p[3], q[3];
    if (std::sscanf(a.c_str(), "%lf,%lf,%lf,%lf", &index, p, p + 1, p + 2) != 4) continue;
    if (std::sscanf(b.c_str(), "%lf,%lf,%lf,%lf", &index, q, q + 1, q + 2) != 4) continue;
    farthest = std::max(farthest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  return farthest;
}

}  // namespace

TEST_CASE("a window without motion uses no processor time, and wakes on input") {
  const SceneDesk desk;
  const std::string scene = desk.scene("cube.json", cube_scene("Test cube", 2e4));
  FasciaWindow window(with_size({scene, "--stats", "stats.json"}), desk.folder.path());
  window.screenshot();  // it is open and shows the scene
  // The usage decreases with the load of the machine: a window that keeps drawing uses most of its share.
  const auto used_in_a_while = [&] {
    const double before = window.processor_seconds();
    for (int i = 0; i < 4; ++i) window.pause();
    return window.processor_seconds() - before;
  };
  double used = 0;
  CHECK(eventually([&] { return (used = used_in_a_while()) < 0.02; }));
  CAPTURE(used);

  window.move(kMiddle, kHeight / 2);
  window.press();
  const Screenshot rest = window.screenshot();
  window.move(kMiddle + 160, kHeight / 2 - 60);
  CHECK(eventually([&] { return changed_share(rest, window.screenshot()) > 0.01; }));
  window.release();
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  const auto stats = nlohmann::json::parse(read_file(desk.folder / "stats.json"));
  CHECK(stats["steps_asleep"].get<long>() > 0);
}

TEST_CASE("tissue is dragged, a slider moved and keys pressed in the window") {
  const SceneDesk desk;
  const std::string scene = desk.scene("cube.json", cube_scene("Test cube", 2e4));
  FasciaWindow window(with_size({scene, "--export", "dragged.csv", "--stats", "stats.json"}), desk.folder.path());
  const Screenshot rest = undisturbed(window);
  CHECK(rest.image.width == kWidth);
  CHECK(rest.title == "Test cube");
  CHECK(rest.young_modulus == 2e4);

  INFO("a drag on tissue deforms it, and letting go and R bring it back");
  window.move(kMiddle, kHeight / 2);
  window.press();
  window.move(kMiddle + 160, kHeight / 2 - 60);
  Screenshot dragged;
  CHECK(eventually([&] { return changed_share(rest, dragged = window.screenshot()) > 0.01; }));
  window.release();
  // No force acts on the tissue after a reset: exactly the picture of rest returns. A busy virtual display can lose a
  // key.
  CHECK(eventually([&] {
    window.key("r");
    return changed_share(rest, undisturbed(window)) < 1e-4;
  }));

  INFO("a slider changes the material of the running scene");
  const Spot knob = first_slider(rest.image);
  REQUIRE(knob.y > 0);
  window.move(knob.x, knob.y);
  window.press();
  window.move(knob.x + 40, knob.y);
  // The button is released only then: a slider ignores a move in the same frame as the release.
  Screenshot stiffer;
  CHECK(eventually([&] { return (stiffer = window.screenshot()).young_modulus > 1e5; }));
  window.release();

  INFO("keys");
  window.key("space");
  Screenshot paused;
  CHECK(eventually([&] {
    const std::string moment = window.screenshot().moment;
    return (paused = window.screenshot()).moment == moment;
  }));
  long step = 0, next = 0;
  REQUIRE(std::sscanf(paused.moment.c_str(), "step %ld", &step) == 1);
  window.key("period");
  CHECK(eventually([&] { return window.screenshot().moment != paused.moment; }));
  REQUIRE(std::sscanf(window.screenshot().moment.c_str(), "step %ld", &next) == 1);
  CHECK(next == step + 1);
  window.key("w");
  Screenshot wire;
  CHECK(eventually([&] { return (wire = window.screenshot()).wireframe; }));
  CHECK(changed_share(paused, wire) > 0.005);
  window.key("h");
  const auto panels_of = [](const Screenshot& shot) {
    return Image{kPanels, kHeight, [&] {
                   std::vector<std::uint8_t> pixels;
                   for (int y = 0; y < kHeight; ++y) {
                     const auto row = shot.image.rgba.begin() + 4 * y * kWidth;
                     pixels.insert(pixels.end(), row, row + 4 * kPanels);
                   }
                   return pixels;
                 }()};
  };
  CHECK(eventually([&] { return difference(panels_of(wire), panels_of(window.screenshot())).share > 0.5; }));

  INFO("closing while the grab still pulls writes the deformed state");
  const Screenshot alone = window.screenshot();  // without panels the scene is in the middle of the window
  window.key("space");
  window.move(kMiddle, kHeight / 2);
  window.press();
  window.move(kMiddle + 160, kHeight / 2 - 60);
  const Screenshot before = window.screenshot();
  CHECK(eventually([&] { return window.screenshot().moment != before.moment; }));
  CHECK(eventually([&] { return changed_share(alone, window.screenshot()) > 0.01; }));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  CAPTURE(window.said());
  const auto stats = nlohmann::json::parse(read_file(desk.folder / "stats.json"));
  CHECK(stats.at("steps").get<long>() > step);
  CHECK(stats.at("nan").get<bool>() == false);
  REQUIRE(
      run_fascia({"run", scene, "--steps", "0", "--context", "osmesa", "--export", (desk.folder / "rest.csv").string()})
          .exit_code == 0);
  const double farthest = farthest_vertex(desk.folder / "dragged.csv", desk.folder / "rest.csv");
  CHECK(farthest > 0.01);  // [m] of a cube of 0.1 m or more
}

TEST_CASE("a scene that cannot be opened keeps the open one, and another opens by its path") {
  const SceneDesk desk;
  const std::string first = desk.scene("first.json", cube_scene("First", 1e5));
  desk.scene("second.json", cube_scene("Second", 1e6));
  desk.scene("broken.json", "{\"fascia_scene\": 1, \"titel\": 3}");
  FasciaWindow window(with_size({first}), desk.folder.path());
  CHECK(window.screenshot().title == "First");

  // Characters typed before the dialog has the keyboard focus are lost, so everything is repeated until it works;
  // Escape closes an error and a dialog that stayed open. On a busy machine a frame takes seconds: every attempt gets
  // more time.
  int patience = 0;
  const auto open = [&](const std::string& name) {
    ++patience;
    const auto wait = [&] {
      for (int i = 0; i < patience; ++i) window.pause();
    };
    window.key("Escape");
    window.key("Escape");
    window.key("ctrl+o");
    wait();
    window.type(name);
    window.key("Return");
    wait();
  };
  // Pixels of the red box of an error (see panels_help.cpp).
  const auto red_pixels = [](const Screenshot& shot) {
    long count = 0;
    for (std::size_t i = 0; i < shot.image.rgba.size(); i += 4)
      count += std::abs(shot.image.rgba[i] - 84) < 12 && std::abs(shot.image.rgba[i + 1] - 26) < 12 &&
               std::abs(shot.image.rgba[i + 2] - 24) < 12;
    return count;
  };
  CHECK(red_pixels(window.screenshot()) < 100);
  for (const char* bad : {"broken.json", "missing.json"}) {
    CAPTURE(bad);
    CHECK(eventually([&] {
      open(bad);
      const Screenshot shot = window.screenshot();
      CHECK(shot.title == "First");
      return red_pixels(shot) > 2000;
    }));
  }
  CHECK(eventually([&] {
    open("second.json");
    return window.screenshot().title == "Second";
  }));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}

TEST_CASE("a window closes by itself after the requested steps") {
  const SceneDesk desk;
  const std::string scene = desk.scene("cube.json", cube_scene("Cube", 1e5));
  const CommandResult result =
      run_fascia(with_size({"view", scene, "--steps", "5", "--stats", "stats.json"}), desk.folder.path());
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(nlohmann::json::parse(read_file(desk.folder / "stats.json")).at("steps") == 5);
}

TEST_CASE("a window opens with measured curves, or says what they lack") {
  const SceneDesk desk;
  const std::string scene = desk.scene("cube.json", cube_scene("Cube", 1e5));
  const auto with = [&](const std::string& content) {
    write_file(desk.folder / "curves.csv", content);
    return run_fascia(with_size({"view", scene, "--steps", "5", "--measured", "curves.csv"}), desk.folder.path());
  };
  const CommandResult shown = with("time_s,probe_y_mm\n0,0\n1,-2\n");
  CAPTURE(shown.err);
  CHECK(shown.exit_code == 0);
  const CommandResult other = with("index,x,y,z\n3,0,0,0\n");
  CAPTURE(other.err);
  CHECK(other.exit_code == 1);
  CHECK_THAT(other.err, Catch::Contains("curves.csv: has no curve over time that the plots show"));
}

TEST_CASE("tissue that diverges repeatedly pauses with a message and a replay; the window and the scene stay") {
  const SceneDesk desk;
  const std::string scene = desk.scene("cube.json", cube_scene("Cube", 1e5));
  Replay broken{open_scene(scene), std::nullopt, {}, 100};
  const Model model = build_model(broken.scene);
  broken.start = initial_state(model);
  const std::vector<char> held = model.held();
  broken.start->displacement[static_cast<std::size_t>(std::find(held.begin(), held.end(), 0) - held.begin())] = {1e25,
                                                                                                                 0, 0};
  write_replay(desk.folder / "broken.fascia", broken);
  FasciaWindow window(with_size({(desk.folder / "broken.fascia").string()}), desk.folder.path());
  std::filesystem::path kept;
  CHECK(eventually([&] {
    for (const auto& entry : std::filesystem::directory_iterator(desk.folder.path()))
      if (entry.path().extension() == ".fascia" && entry.path().stem().string().rfind("fascia-", 0) == 0)
        kept = entry.path();
    return !kept.empty();
  }));
  CHECK(window.running());
  CHECK(window.screenshot().title == "Cube");
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  const CommandResult again = run_fascia({"run", "--replay", kept.string(), "--context", "osmesa"}, desk.folder.path());
  CAPTURE(again.err);
  CHECK(again.exit_code == 1);
  CHECK(again.err.find("diverged at ") != std::string::npos);
}

TEST_CASE("a session in the window is replayed to the bit, also one that was killed", "[window][session]") {
  const SceneDesk desk;
  const std::string scene = desk.scene("cube.json", cube_scene("Test cube", 2e4));
  const std::filesystem::path sessions = state_folder() / "sessions";  // of this display
  const auto only_session = [&] {
    std::filesystem::path found;
    for (const auto& entry : std::filesystem::directory_iterator(sessions)) found = entry.path();
    return found;
  };
  const auto inputs = [&] { return read_replay(only_session()).inputs; };
  {
    FasciaWindow window(with_size({scene, "--export", "lived.csv"}), desk.folder.path());
    const Screenshot start = window.screenshot();
    const Spot slider = first_slider(start.image);
    REQUIRE(slider.y > 0);
    window.move(kMiddle, kHeight / 2);
    window.press();
    window.move(kMiddle + 120, kHeight / 2 - 60);
    window.screenshot();  // each of these drags lasts some frames on any machine
    window.release();
    window.move(slider.x, slider.y);
    window.press();
    window.screenshot();
    window.move(slider.x + 40, slider.y);
    window.screenshot();
    window.release();
    window.key("w");
    window.move(kWidth - 80, kHeight - 120);  // beside the cube: the view rotates
    window.press();
    window.move(kWidth - 160, kHeight - 150);
    window.screenshot();
    window.release();
    window.key("r");
    window.pause();
    window.pause();
    window.key("ctrl+q");
    CHECK(window.wait() == 0);
    CAPTURE(window.said());
  }
  const std::vector<Input> all = inputs();
  const auto has = [&](auto kind) {
    return std::any_of(all.begin(), all.end(),
                       [&](const Input& input) { return std::holds_alternative<decltype(kind)>(input.change); });
  };
  CHECK(has(GrabInput{}));
  CHECK(has(GrabMove{}));
  CHECK(has(MaterialInput{}));
  CHECK(has(CameraSettings{}));
  CHECK(has(DisplaySettings{}));
  CHECK(has(ResetInput{}));
  const CommandResult again =
      run_fascia({"run", "--replay", only_session().string(), "--export", "again.csv"}, desk.folder.path());
  CAPTURE(again.err);
  CHECK(again.exit_code == 0);
  CHECK(again.err.find("fascia: the state is the recorded one to the bit") != std::string::npos);
  CHECK((read_file(desk.folder / "again.csv") == read_file(desk.folder / "lived.csv")));

  // The next window is killed in the middle of a drag.
  std::filesystem::remove_all(sessions);
  {
    FasciaWindow window(with_size({scene}), desk.folder.path());
    window.screenshot();
    window.move(kMiddle, kHeight / 2);
    window.press();
    window.move(kMiddle + 120, kHeight / 2 - 60);
    CHECK(eventually([&] {
      const std::vector<Input> written = inputs();
      return std::any_of(written.begin(), written.end(),
                         [](const Input& input) { return std::holds_alternative<GrabMove>(input.change); });
    }));
    window.kill_at_once();
  }
  const Replay torn = read_replay(only_session());
  CHECK(torn.steps > 0);
  CHECK_FALSE(torn.hash);
  const CommandResult repeated = run_fascia({"run", "--replay", only_session().string()}, desk.folder.path());
  CAPTURE(repeated.err);
  CHECK(repeated.exit_code == 0);
}
