// Files and plots in the real window: examples, a state that survives a kill, a canceled opening, plots as files.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/system/user_settings.h"
#include "base/file.h"
#include "base/provenance.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/replay/replay.h"
#include "sim/scene/scene.h"
#include "tests/support/window/window_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

struct FileDesk {
  TemporaryFolder folder;
  VirtualDisplay display{kWidth, kHeight};
  std::string scene(const std::string& title, double young_modulus) const {
    const nlohmann::json scene{{"fascia_scene", 1},
                               {"title", title},
                               {"bodies",
                                {{{"mesh", (source_dir() / "assets/meshes/cube.msh").string()},
                                  {"materials", {{"default", {{"young_modulus", young_modulus}}}}},
                                  {"fixed", {{{"group", "clamp"}}}}}}}};
    write_file(folder / (title + ".json"), scene.dump());
    return (folder / (title + ".json")).string();
  }
  /// Complete files only: the name of an incomplete one begins with a dot.
  std::vector<std::filesystem::path> with_ending(const std::string& ending, const std::filesystem::path& where) const {
    std::vector<std::filesystem::path> found;
    std::error_code ec;
    for (std::filesystem::directory_iterator it(where, ec), end; !ec && it != end; it.increment(ec))
      if (it->path().extension() == ending && it->path().filename().string()[0] != '.') found.push_back(it->path());
    return found;
  }
};

long step_of(const Screenshot& shot) {
  long step = -1;
  std::sscanf(shot.moment.c_str(), "step %ld", &step);
  return step;
}

}  // namespace

TEST_CASE("the state of a killed window is offered by the next one, and restored with its values") {
  const FileDesk desk;
  // Its mesh is beside it, and the next window starts in another folder.
  const std::filesystem::path models = desk.folder / "models";
  std::filesystem::create_directory(models);
  std::filesystem::copy_file(source_dir() / "assets/meshes/cube.msh", models / "cube.msh");
  nlohmann::json document = nlohmann::json::parse(read_file(desk.scene("killed", 2e5)));
  std::filesystem::remove(desk.folder / "killed.json");
  document["bodies"][0]["mesh"] = "cube.msh";
  const std::string scene = (models / "killed.json").string();
  write_file(scene, document.dump());
  {
    FasciaWindow window(with_size({scene, "--set", "materials.default.young_modulus=3e4"}), desk.folder.path());
    CHECK(window.screenshot().young_modulus == 3e4);
    CHECK(eventually([&] { return !desk.with_ending(".fascia", desk.display.state()).empty(); }));
    window.kill_at_once();
  }
  const std::string other = desk.scene("other", 1e6);
  FasciaWindow window(with_size({other}), desk.folder.path());
  CHECK(window.screenshot().title == "other");
  // The offer is at the top, centered beside the panels; its button is right of the center.
  CHECK(eventually([&] {
    for (int x = kWidth / 2 + 100; x < kWidth - 60; x += 30) {
      window.move(x, 72);
      window.pause();
      window.press();
      window.pause();
      window.release();
      if (window.screenshot().title == "killed") return true;
    }
    return false;
  }));
  CHECK(window.screenshot().young_modulus == 3e4);
  const std::filesystem::path saved = desk.folder / "killed.json";
  int patience = 0;  // keys before the dialog opens are lost, and on a busy machine a frame takes seconds
  const auto wait = [&] {
    for (int i = 0; i < patience; ++i) window.pause();
  };
  REQUIRE(eventually([&] {
    ++patience;
    window.key("Escape");
    wait();
    window.key("ctrl+s");
    wait();
    window.key("Return");
    wait();
    return std::filesystem::exists(saved);
  }));
  const Scene again = open_scene(saved);
  CHECK(again.bodies.at(0).material.young_modulus == 3e4);
  CHECK(std::filesystem::equivalent(again.resolve(again.bodies.at(0).mesh), models / "cube.msh"));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  const auto left = desk.with_ending(".fascia", desk.display.state());
  REQUIRE(left.size() == 1);
  CHECK_THAT(left[0].filename().string(), Catch::Contains(".last.fascia"));
  const UserSettings settings = read_user_settings(desk.display.settings());
  REQUIRE(settings.recent.size() == 3);
  CHECK(settings.recent[0] == saved);
  CHECK(settings.recent[1] == other);
  CHECK(settings.recent[2] == scene);
}

TEST_CASE("two windows keep their states apart") {
  const FileDesk desk;
  FasciaWindow one(with_size({desk.scene("one", 2e5)}), desk.folder.path());
  CHECK(eventually([&] { return desk.with_ending(".fascia", desk.display.state()).size() == 1; }));
  std::filesystem::create_directory(desk.folder / "two");
  FasciaWindow two(with_size({desk.scene("two", 2e5)}), desk.folder / "two");
  CHECK(eventually([&] { return desk.with_ending(".fascia", desk.display.state()).size() == 2; }));
  one.kill_at_once();
  two.kill_at_once();
  CHECK(desk.with_ending(".fascia", desk.display.state()).size() == 2);
}

TEST_CASE("an example opens with one click, and the gallery is offered to a new user") {
  const FileDesk desk;
  write_user_settings(desk.display.settings(), {});
  FasciaWindow window(with_size({}), desk.folder.path());
  CHECK(window.screenshot().title.find("Liver") != std::string::npos);
  INFO("the strip is below the tissue, which can be grabbed beside it; the third picture is the beam");
  window.move(656, 616);
  window.press();
  window.pause();
  window.release();
  CHECK(eventually([&] { return window.screenshot().title.find("Beam") != std::string::npos; }));
  CHECK(read_user_settings(desk.display.settings()).first_run_done);
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}

TEST_CASE("opening a large mesh is canceled with Escape, and the open scene continues") {
  const FileDesk desk;
  const std::string scene = desk.scene("small", 2e5);
  write_mesh(desk.folder / "large.msh", make_box(48, 48, 48, {1, 1, 1}));
  FasciaWindow window(with_size({scene}), desk.folder.path());
  const long before = step_of(window.screenshot());
  window.key("ctrl+o");
  for (int i = 0; i < 3; ++i) window.pause();
  window.type("large.msh");
  window.key("Return");
  for (int i = 0; i < 14; ++i) {  // reading alone takes longer than the time between two of them
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    window.key("Escape");
  }
  const Screenshot after = window.screenshot();
  CHECK(after.title == "small");
  CHECK(step_of(after) >= before);
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}

TEST_CASE("a video that fails when the window closes affects neither the export nor the recorded session") {
  const FileDesk desk;
  const std::string scene = desk.scene("filmed", 5e3);
  std::filesystem::create_directory(desk.folder / "tools");
  write_file(desk.folder / "tools/ffmpeg",
             "#!/bin/sh\ntouch started\ncat >/dev/null\necho 'No space left on device' >&2\nexit 1\n");
  std::filesystem::permissions(desk.folder / "tools/ffmpeg", std::filesystem::perms::owner_all);
  const std::string usual = getenv("PATH");
  setenv("PATH", ((desk.folder / "tools").string() + ":" + usual).c_str(), 1);
  FasciaWindow window(with_size({scene, "--export", "end.csv"}), desk.folder.path());
  setenv("PATH", usual.c_str(), 1);
  window.screenshot();
  window.key("v");
  CHECK(eventually([&] { return std::filesystem::exists(desk.folder / "started"); }));
  window.key("r");  // an input to record
  window.screenshot();
  window.key("ctrl+q");
  CHECK(window.wait() == 1);
  CHECK_THAT(window.said(), Catch::Contains("No space left on device"));
  CHECK(std::filesystem::exists(desk.folder / "end.csv"));
  const auto sessions = desk.with_ending(".fascia", desk.display.state() / "sessions");
  REQUIRE(sessions.size() == 1);
  CHECK(read_replay(sessions[0]).hash);  // recorded to its end
  CHECK(desk.with_ending(".fascia", desk.display.state()).size() == 1);
}

TEST_CASE("plots are written as a table of the shown values, and the state is exported") {
  const FileDesk desk;
  const std::string scene = desk.scene("plotted", 5e3);
  FasciaWindow window(with_size({scene}), desk.folder.path());
  window.screenshot();
  window.key("F3");
  window.pause();
  const auto tables = [&] { return desk.with_ending(".csv", desk.folder.path()); };
  // The buttons are below the title of the panel at the bottom: Hold, Clear, Point, CSV, PNG, Charts.
  CHECK(eventually([&] {
    window.move(708, 442);
    window.press();
    window.pause();
    window.release();
    window.pause();
    return !tables().empty();
  }));
  CHECK(eventually([&] {
    window.key("Escape");
    window.key("ctrl+e");
    window.pause();
    window.key("Return");
    window.pause();
    return std::filesystem::exists(desk.folder / "plotted.vtu");
  }));
  CHECK(read_mesh(desk.folder / "plotted.vtu").mesh.tets.size() == 500);
  CHECK_FALSE(find_provenance(read_file(desk.folder / "plotted.vtu")).empty());
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  const std::string table = read_file(tables().front());
  CHECK_THAT(table, Catch::Contains("# Title: plotted") &&
                        Catch::Contains("\nstep,time_s,kinetic_J,elastic_J,gravitational_J,total_J,"));
  CHECK(std::count(table.begin(), table.end(), '\n') >
        9);  // seven notes of provenance, the vertex, the names, and rows
}
