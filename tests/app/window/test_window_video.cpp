// Videos and pictures that are recorded in the real window: of the chosen size, without panels.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "app/video/video_settings.h"
#include "base/file.h"
#include "render/target/image.h"
#include "tests/support/window/window_fixture.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

struct VideoDesk {
  TemporaryFolder folder;
  VirtualDisplay display{1000, 700};
  FasciaWindow window{{scene(), "--size", "960x640"}, folder.path()};

  std::string scene() const {
    write_file(folder / "cube.json", cube_scene("Test cube", 2e4));
    return (folder / "cube.json").string();
  }
  /// The newest file with this extension; for pictures the folder.
  fs::path recorded(const std::string& ending) const {
    fs::path found;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      const bool named = entry.path().filename().string().starts_with("fascia-");
      if (named && entry.path().extension() == ending && entry.is_directory() == ending.empty())
        found = std::max(found, entry.path());
    }
    return found;
  }
  void record() {
    window.key("v");
    window.screenshot();
    window.key("r");  // awake, so that there are frames
    window.screenshot();
    window.key("v");
  }
};

std::string size_of_video(const fs::path& path) {
  return run_command({"ffprobe", "-v", "error", "-select_streams", "v:0", "-show_entries", "stream=width,height", "-of",
                      "csv=p=0", path.string()})
      .out;
}

}  // namespace

TEST_CASE("videos and pictures have the chosen size and no panels, for any size of the window", "[video]") {
  VideoDesk desk;
  FasciaWindow& window = desk.window;
  window.resize(957, 640);  // as a window manager that reserves space for a frame
  CHECK(eventually([&] { return window.screenshot().image.width == 957; }));
  desk.record();
  CHECK(eventually([&] { return !desk.recorded(".mp4").empty(); }));
  CHECK(size_of_video(desk.recorded(".mp4")) == "960,640\n");

  INFO("pictures, by the panel Recording");
  window.key("shift+v");
  window.move(606, 146);  // PNGs
  window.press();
  window.release();
  desk.record();
  fs::path last;
  CHECK(eventually([&] {
    const fs::path folder = desk.recorded("");
    if (folder.empty()) return false;
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".png") last = std::max(last, entry.path());
    return !last.empty();
  }));
  const Image picture = read_png(last);
  CHECK(picture.width == 960);
  CHECK(picture.height == 640);
  // The panels are nearly opaque and darker than the background.
  const auto brightness = [&](int x, int y) {
    const std::uint8_t* p = &picture.rgba[4 * (static_cast<std::size_t>(y) * picture.width + x)];
    return int{p[0]} + p[1] + p[2];
  };
  CAPTURE(brightness(20, 60), brightness(940, 60));
  CHECK(std::abs(brightness(20, 60) - brightness(940, 60)) < 12);

  INFO("of the size of the window, on request");
  window.move(459, 175);  // Window
  window.press();
  window.release();
  window.resize(941, 641);
  CHECK(eventually([&] { return window.screenshot().image.width == 941; }));
  const fs::path before = desk.recorded("");
  desk.record();
  CHECK(eventually([&] { return desk.recorded("") != before && fs::exists(desk.recorded("") / "00000.png"); }));
  const Image own = read_png(desk.recorded("") / "00000.png");
  CHECK(own.width == 941);
  CHECK(own.height == 641);
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}

TEST_CASE("a size is even for a video, and arbitrary for pictures") {
  VideoSettings settings;
  CHECK_FALSE(settings.panels);
  for (const auto kind : {VideoKind::mp4, VideoKind::webm, VideoKind::pictures}) {
    settings.kind = kind;
    settings.width = settings.height = 0;
    const bool any = kind == VideoKind::pictures;
    CHECK(settings.size_in({1279, 721}).width == (any ? 1279 : 1278));
    CHECK(settings.size_in({1279, 721}).height == (any ? 721 : 720));
    settings.width = 1280;
    settings.height = 720;
    CHECK(settings.size_in({1279, 721}).width == 1280);
    CHECK(settings.size_in({1279, 721}).height == 720);
  }
}
