// Undo, redo and the comparison of two settings in the real window, by hands.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "sim/file.h"
#include "tests/app/window_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr int kWidth = 1280, kHeight = 720, kPanels = 340;

std::string cube_scene() {
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

// The middle of the first slider's knob.
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

TEST_CASE("a drag of a slider is taken back and done again by keys, and two settings are compared") {
  const TemporaryFolder folder;
  const VirtualDisplay display(kWidth, kHeight);
  write_file(folder / "cube.json", cube_scene());
  FasciaWindow window({(folder / "cube.json").string(), "--size", std::to_string(kWidth) + "x" + std::to_string(kHeight)}, folder.path());
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
