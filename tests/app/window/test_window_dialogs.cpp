// Dialogs of the real window, by keys: saving with folders, confirmation before a file is replaced, errors in front of
// everything.
#include <catch2/catch.hpp>
#include <cmath>

#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/replay/replay.h"
#include "sim/scene/scene.h"
#include "tests/support/window/window_fixture.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

struct DialogDesk {
  TemporaryFolder folder;
  VirtualDisplay display{1000, 700};
  std::string text = cube_scene("Test cube", 2e4);
  FasciaWindow window{{scene(), "--size", "1000x700"}, folder.path()};

  std::string scene() const {
    write_file(folder / "cube.json", text);
    return (folder / "cube.json").string();
  }
  void keys(const std::vector<std::string>& names) {
    for (const std::string& name : names) window.key(name);
  }
  /// Pixels of the red box of an error (see panels_help.cpp) on the screen, above the gallery, whose tissues are red,
  /// too.
  long red_pixels() const {
    const Image image = display.watch(1).front();
    long count = 0;
    const std::size_t above_gallery = 4 * static_cast<std::size_t>(image.width) * 540;
    for (std::size_t i = 0; i < above_gallery; i += 4)
      count += std::abs(image.rgba[i] - 84) < 12 && std::abs(image.rgba[i + 1] - 26) < 12 &&
               std::abs(image.rgba[i + 2] - 24) < 12;
    return count;
  }
};

}  // namespace

TEST_CASE("a scene is saved to a folder selected by keys, and a file is replaced only after confirmation",
          "[dialogs]") {
  DialogDesk desk;
  FasciaWindow& window = desk.window;
  fs::create_directory(desk.folder / "out");
  fs::create_directory(desk.folder / "out/deeper");
  window.screenshot();

  INFO("Enter alone, also twice, replaces nothing, and Escape goes back step by step");
  desk.keys({"ctrl+s", "Return", "Return", "Return", "Escape", "Escape"});
  window.screenshot();
  CHECK(read_file(desk.folder / "cube.json") == desk.text);

  INFO("the other button replaces it");
  desk.keys({"ctrl+s", "Return", "Right", "Return"});
  CHECK(eventually([&] { return read_file(desk.folder / "cube.json") != desk.text; }));
  CHECK(open_scene(desk.folder / "cube.json").title == "Test cube");

  INFO("the folder above, then out/, then a name of its own; the ending comes by itself");
  desk.keys({"ctrl+s", "Down", "Down", "Return", "Return"});
  CHECK(eventually([&] { return fs::exists(desk.folder / "out/cube.json"); }));
  window.key("ctrl+s");
  window.type("other");
  window.key("Return");
  CHECK(eventually([&] { return fs::exists(desk.folder / "out/other.json"); }));
  window.key("ctrl+s");
  window.type((desk.folder / "elsewhere.json").string());
  window.key("Return");
  CHECK(eventually([&] { return fs::exists(desk.folder / "elsewhere.json"); }));

  INFO("a folder that is not there and an ending that is none are refused in the dialog, which stays");
  window.key("ctrl+s");
  window.type("nowhere/a.json");
  window.key("Return");
  window.key("ctrl+a");
  window.type("a.txt");
  window.key("Return");
  window.key("ctrl+a");
  window.type("deeper/a.json");
  window.key("Return");
  CHECK(eventually([&] { return fs::exists(desk.folder / "out/deeper/a.json"); }));
  CHECK_FALSE(fs::exists(desk.folder / "out/a.txt"));
  CHECK_FALSE(fs::exists(desk.folder / "out/nowhere"));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}

TEST_CASE("a state and a replay are saved by the same dialog", "[dialogs]") {
  DialogDesk desk;
  FasciaWindow& window = desk.window;
  fs::create_directory(desk.folder / "out");
  window.screenshot();
  window.key("ctrl+e");
  window.type("out/state.msh");
  window.key("Return");
  CHECK(eventually([&] { return fs::exists(desk.folder / "out/state.msh"); }));
  CHECK(read_mesh(desk.folder / "out/state.msh").mesh.tets.size() == 500);
  window.key("ctrl+r");
  window.type("out/session");
  window.key("Return");
  CHECK(eventually([&] { return fs::exists(desk.folder / "out/session.fascia"); }));
  CHECK(read_replay(desk.folder / "out/session.fascia").scene.title == "Test cube");
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}

TEST_CASE("a click selects a folder and a file in the save dialog", "[dialogs]") {
  DialogDesk desk;
  FasciaWindow& window = desk.window;
  fs::create_directory(desk.folder / "out");
  write_file(desk.folder / "out/kept.json", "kept");
  window.screenshot();
  window.key("ctrl+s");
  const auto click = [&](int x, int y) {
    window.move(x, y);
    window.press();
    window.release();
  };
  click(450, 205);  // out/, below ../
  click(450, 205);  // kept.json, below ../
  window.key("Return");
  window.key("Return");
  window.screenshot();
  CHECK(read_file(desk.folder / "out/kept.json") == "kept");
  desk.keys({"ctrl+s", "Down", "Down", "Return", "Right", "space"});
  CHECK(eventually([&] { return read_file(desk.folder / "out/kept.json") != "kept"; }));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}

TEST_CASE("an error is in front of panels and dialogs, and Escape closes it first", "[dialogs]") {
  DialogDesk desk;
  FasciaWindow& window = desk.window;
  window.screenshot();
  CHECK(desk.red_pixels() < 100);
  window.key("ctrl+o");
  window.type("missing.json");
  window.key("Return");
  long red = 0;
  CHECK(eventually([&] { return (red = desk.red_pixels()) > 2000; }));
  // Recording and the list of keys open at its place, the gallery below it.
  for (const char* key : {"shift+v", "F1", "F2"}) {
    window.key(key);
    for (int i = 0; i < 3; ++i) window.pause();
    const long now = desk.red_pixels();
    CAPTURE(key, red, now);
    CHECK(std::abs(now - red) <
          red / 100);  // a panel in front hides thousands; the edge of the box blends with what is behind it
  }
  window.key("Escape");
  CHECK(eventually([&] { return desk.red_pixels() < 100; }));
  const Image opened = desk.display.watch(1).front();
  window.key("Escape");
  CHECK(eventually([&] { return difference(opened, desk.display.watch(1).front()).share > 0.1; }));

  INFO("its button closes it, too, also beside a dialog");
  window.key("Escape");
  window.key("ctrl+o");
  window.type("missing.json");
  window.key("Return");
  CHECK(eventually([&] { return desk.red_pixels() > 2000; }));
  window.key("F2");
  CHECK(eventually([&] {
    for (int y = 84; y < 130; y += 8) {
      window.move(440, y);
      window.press();
      window.release();
    }
    return desk.red_pixels() < 100;
  }));
  window.key("Escape");
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}
