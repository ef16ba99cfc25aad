// A waiting window: for kernels on a machine whose driver has none yet, and for input while nothing moves.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "tests/support/window/window_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

struct NoKernels {
  NoKernels() { setenv("MESA_SHADER_CACHE_DISABLE", "true", 1); }
  ~NoKernels() { unsetenv("MESA_SHADER_CACHE_DISABLE"); }
  NoKernels(const NoKernels&) = delete;
  NoKernels& operator=(const NoKernels&) = delete;
};

// Whether the sky, above the center of the scene, is behind the dark pill of the notice.
bool shows_notice(const Image& image) {
  constexpr int kRow = 58;
  const auto red = [&](int x, int y) {
    return static_cast<int>(image.rgba[4 * (static_cast<std::size_t>(y) * image.width + x)]);
  };
  return red(kPanels + 20, kRow) > 120 && red(kMiddle - 100, kRow - 3) < 90 && red(kMiddle + 100, kRow - 3) < 90;
}

}  // namespace

TEST_CASE("a window reports that it compiles kernels, then continues with earlier inputs") {
  const TemporaryFolder folder;
  const VirtualDisplay display(kWidth, kHeight);
  write_file(folder / "cube.json", cube_scene("Test cube", 2e4));
  const NoKernels no_kernels;
  FasciaWindow window({(folder / "cube.json").string(), "--stats", "stats.json", "--size", "1000x700"}, folder.path());
  std::vector<Image> seen;
  CHECK(eventually([&] { return std::ranges::any_of(seen = display.watch(8), shows_notice); }));
  CHECK(eventually([&] { return std::ranges::none_of(seen = display.watch(8), shows_notice); }));

  const Image rest = right_part(window.screenshot().image, kPanels);
  window.move((kPanels + kWidth) / 2, kHeight / 2);
  window.press();
  window.move((kPanels + kWidth) / 2 + 160, kHeight / 2 - 60);  // while the kernels of a grab are compiled
  CHECK(eventually([&] { return difference(rest, right_part(window.screenshot().image, kPanels)).share > 0.02; }));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}

TEST_CASE("a waiting window shows its current state: no obsolete notice, and a bar that matches the colors") {
  const TemporaryFolder folder;
  const VirtualDisplay display(kWidth, kHeight);
  // Sinks under its weight, with more work per step than any software renderer does in time, and falls asleep.
  auto scene = nlohmann::json::parse(cube_scene("Test cube", 2e4));
  scene["bodies"][0]["materials"]["default"]["damping"] = 0.03;  // nearly critical: few steps lead to rest
  scene["gravity"] = {0, -9.81, 0};
  scene["display"] = {{"color", "velocity"}};
  scene["solver"] = {{"substeps", 4}, {"iterations", 100}, {"rest_speed", 0.01}};
  write_file(folder / "cube.json", scene.dump());
  FasciaWindow window({(folder / "cube.json").string(), "--size", "1000x700"}, folder.path());
  const auto becomes_idle = [&] {
    double used = 0;
    const bool idle = eventually([&] {
      const double before = window.processor_seconds();
      for (int i = 0; i < 4; ++i) window.pause();
      return (used = window.processor_seconds() - before) < 0.02;
    });
    CAPTURE(used);
    CHECK(idle);
  };
  const auto shown = [&] { return right_part(display.watch(1).front(), kPanels); };
  const auto slow = [](const Image& image) {  // the color of the notice, at the top
    int pixels = 0;
    for (int y = 10; y < 50; ++y)
      for (int x = 0; x < image.width; ++x) {
        const std::uint8_t* p = &image.rgba[4 * (static_cast<std::size_t>(y) * image.width + x)];
        pixels += p[0] > 200 && p[1] > 140 && p[2] < 130;
      }
    return pixels;
  };
  int warned = 0;
  CHECK(eventually([&] { return (warned = slow(shown())) > 20; }));
  window.move(8, 8);  // from the tissue, which shows what a grab would take
  becomes_idle();
  const Image waits = shown();
  CAPTURE(warned, slow(waits));
  CHECK(slow(waits) == 0);
  window.move(4, 4);  // over nothing
  becomes_idle();
  const ImageDifference woken = difference(waits, shown());
  CAPTURE(woken.mean, woken.share);
  CHECK(woken.share == 0);
}
