// A window on a machine whose driver has none of its kernels yet.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "sim/file.h"
#include "tests/app/window_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr int kWidth = 1000, kHeight = 700, kPanels = 338;

struct NoKernels {
  NoKernels() { setenv("MESA_SHADER_CACHE_DISABLE", "true", 1); }
  ~NoKernels() { unsetenv("MESA_SHADER_CACHE_DISABLE"); }
  NoKernels(const NoKernels&) = delete;
  NoKernels& operator=(const NoKernels&) = delete;
};

// Whether the sky, in the middle over the scene, is behind the dark pill of the notice.
bool shows_notice(const Image& image) {
  constexpr int kX = (kPanels + kWidth) / 2, kY = 58;
  const auto red = [&](int x, int y) { return static_cast<int>(image.rgba[4 * (static_cast<std::size_t>(y) * image.width + x)]); };
  return red(kPanels + 20, kY) > 120 && red(kX - 100, kY - 3) < 90 && red(kX + 100, kY - 3) < 90;
}

}  // namespace

TEST_CASE("a window says that it compiles kernels, then goes on with what was done meanwhile") {
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
  window.move((kPanels + kWidth) / 2 + 160, kHeight / 2 - 60);  // while what a hand needs is compiled
  CHECK(eventually([&] { return difference(rest, right_part(window.screenshot().image, kPanels)).share > 0.02; }));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}
