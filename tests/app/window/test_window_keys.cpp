// Keys in the real window: faster than its frames, and keys for the panels.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "tests/support/window/window_fixture.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("keys with Ctrl and Shift that are pressed and released within a frame reach a text field") {
  const TemporaryFolder folder;
  const VirtualDisplay display(kWidth, kHeight);
  write_file(folder / "cube.json", cube_scene("Test cube", 2e4));
  FasciaWindow window({(folder / "cube.json").string(), "--size", "1000x700"}, folder.path());
  window.screenshot();
  window.move(278, 280);  // the number of Young's modulus
  window.press();
  window.release();
  window.pause();
  for (int i = 0; i < 10; ++i) {
    window.keys_at_once(std::vector<std::string>(8, "ctrl+a"));
    window.keys_at_once(std::vector<std::string>(8, "shift+p"));
  }
  window.pause();
  CHECK(window.running());
  CHECK(eventually([&] {
    window.key("Escape");
    window.key("ctrl+q");
    window.pause();
    return !window.running();
  }));
  CHECK(window.wait() == 0);
}

TEST_CASE("Escape closes a list of the panels, and grabs that stay are kept") {
  const TemporaryFolder folder;
  const VirtualDisplay display(kWidth, kHeight);
  write_file(folder / "cube.json", cube_scene("Test cube", 2e4));
  FasciaWindow window({(folder / "cube.json").string(), "--stats", "stats.json", "--size", "1000x700"}, folder.path());
  const Image rest = right_part(window.screenshot().image, kPanels);
  window.move(kMiddle, kHeight / 2);
  window.press();
  window.move(kMiddle + 60, kHeight / 2 - 60);
  CHECK(eventually([&] { return difference(rest, right_part(window.screenshot().image, kPanels)).share > 0.01; }));
  window.key("t");
  window.release();
  window.move(184, 185);  // the tab Solver
  window.press();
  window.release();
  window.move(215, 251);  // the list of methods, which opens below
  window.screenshot();
  const auto panels = [&] {
    Image image = display.watch(1).front();
    for (int y = 0; y < image.height; ++y)  // the scene may still move
      std::fill_n(image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + kPanels),
                  4 * (image.width - kPanels), std::uint8_t{0});
    return image;
  };
  const Image closed = panels();
  const auto open = [&] { return difference(closed, panels()).share > 0.02; };
  window.press();
  window.release();
  CHECK(eventually(open));
  window.key("Escape");
  CHECK(eventually([&] { return !open(); }));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  const auto stats = nlohmann::json::parse(read_file(folder / "stats.json"));
  CAPTURE(stats.at("grab_N").dump());
  CHECK(stats.at("grab_N").at("hands").size() == 1);
}
