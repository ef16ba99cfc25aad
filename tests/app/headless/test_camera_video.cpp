// Pictures and videos for papers: presets, marks, legends, turntables, cameras with keys, ranges of colors.
// Covers: app/cli/picture_preset
#include <catch2/catch.hpp>
#include <filesystem>

#include "app/cli/picture_preset.h"
#include "base/file.h"
#include "render/target/image.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Catch::Contains;

namespace {

std::string cube() { return (source_dir() / "assets/scenes/cube.json").string(); }

CommandResult render(std::vector<std::string> more, const std::string& size = "96x64") {
  more.insert(more.begin(), {"render", cube(), "--context", "osmesa", "--size", size});
  return run_fascia(more);
}

std::size_t files_in(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

double mean_difference(const Image& a, const Image& b) {
  REQUIRE(a.rgba.size() == b.rgba.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(int(a.rgba[i]) - int(b.rgba[i]));
  return sum / static_cast<double>(a.rgba.size());
}

}  // namespace

TEST_CASE("around tissue in static equilibrium a video is as long as one turn, which closes", "[camera_video]") {
  const TemporaryFolder folder;
  const CommandResult result = render({"--static", "--turntable", "1s", "--fps", "8", "--video", folder / "%02d.png"});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(files_in(folder.path()) == 8);
  std::vector<Image> frames;
  for (int k = 0; k < 8; ++k) frames.push_back(read_png(folder / ("0" + std::to_string(k) + ".png")));
  // A cube on its corner of the grid looks alike after quarters of a turn but for the light: no two frames are equal.
  for (std::size_t k = 1; k < 8; ++k) {
    CAPTURE(k, mean_difference(frames[k - 1], frames[k]));
    CHECK(mean_difference(frames[k - 1], frames[k]) > 0.5);
  }
}

TEST_CASE("degrees are those of the whole video, and a turn of 360 of 0 seconds leaves the first picture",
          "[camera_video]") {
  const TemporaryFolder half, whole;
  const std::vector<std::string> usual{"--steps", "4", "--fps", "60", "--video"};
  const auto frames = [&](const TemporaryFolder& folder, const std::string& degrees) {
    std::vector<std::string> all = usual;
    all.insert(all.end(), {folder / "%02d.png", "--turntable", degrees});
    const CommandResult result = render(all);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    REQUIRE(files_in(folder.path()) == 4);
  };
  frames(half, "180deg");
  frames(whole, "360deg");
  // After twice as many steps half the angle is the same: 2/4 of 180 is 1/4 of 360, of tissue that hardly moves.
  const Image a = read_png(half / "02.png"), b = read_png(whole / "01.png"), other = read_png(whole / "02.png");
  CAPTURE(mean_difference(a, b), mean_difference(a, other));
  CHECK(mean_difference(a, b) < 0.2 * mean_difference(a, other));
}

TEST_CASE("a video without motion needs a camera that moves", "[camera_video]") {
  const TemporaryFolder folder;
  const CommandResult still = render({"--static", "--video", folder / "%02d.png"});
  CHECK(still.exit_code == 2);
  CHECK_THAT(still.err, Contains("expected --turntable SECONDS, camera.keys, or no --video"));
  const CommandResult keys = render({"--static", "--fps", "6", "--video", folder / "%02d.png", "--set",
                                     R"(camera.keys=[{"time":0,"orbit_deg":0},{"time":1,"orbit_deg":60,"zoom":1.5}])"});
  INFO(keys.err);
  CHECK(keys.exit_code == 0);
  CHECK(files_in(folder.path()) == 6);
  CHECK(render({"--out", folder / "x.png", "--turntable", "8s"}).exit_code == 2);  // turns only in a video
}

TEST_CASE("a growing range is reported with the value that gives the video one range", "[camera_video]") {
  const TemporaryFolder folder;
  const std::vector<std::string> usual{"--steps", "12", "--color", "displacement", "--video", folder / "%02d.png"};
  const CommandResult grew = render(usual);
  CHECK_THAT(grew.err, Contains("the range of the colors grew in the video; display.range=[0,"));
  std::vector<std::string> fixed = usual;
  fixed.insert(fixed.end(), {"--set", "display.range=[0,0.1]"});
  CHECK_THAT(render(fixed).err, !Contains("range of the colors"));
}

TEST_CASE("marks, ground and background are those of the preset, each under --set", "[camera_video]") {
  const TemporaryFolder folder;
  const auto picture = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--steps", "0", "--out", folder / "p.png"});
    const CommandResult result = render(more, "320x240");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return read_png(folder / "p.png");
  };
  const auto corner = [](const Image& image) { return std::vector<int>(image.rgba.begin(), image.rgba.begin() + 3); };
  const Image paper = picture({"--preset", "paper", "--samples", "4"});
  CHECK(corner(paper) == std::vector<int>{255, 255, 255});
  const Image black = picture({"--preset", "paper", "--samples", "4", "--set", "display.background=black"});
  CHECK(corner(black) != corner(paper));
  const Image marked = picture({"--preset", "paper", "--samples", "4", "--set", "display.marks=true"});
  CHECK(mean_difference(paper, marked) > 0);
  const Image dots = picture({"--preset", "paper", "--samples", "4", "--set", R"(display.marks=["fixed"])"});
  CHECK(dots.rgba == marked.rgba);  // the scene has no grabs
  CHECK_THAT(render({"--preset", "papers", "--out", "never.png"}).err, Contains("perhaps \"paper\""));
}

TEST_CASE("the guide lists the values of every preset", "[camera_video]") {
  const std::string guide = read_file(source_dir() / "docs/guide/command-line.md");
  REQUIRE(!picture_presets().empty());
  for (const PicturePreset& preset : picture_presets()) {
    for (const std::string& set : preset.sets) {
      CAPTURE(preset.name, set);
      CHECK(guide.find("`" + set + "`") != std::string::npos);
    }
    CHECK(guide.find("`--samples " + std::to_string(preset.samples) + "`") != std::string::npos);
    CHECK(preset_sets(preset.name) == preset.sets);
  }
  CHECK(preset_sets("").empty());
}

TEST_CASE("a legend file belongs to a picture with colors", "[camera_video]") {
  const TemporaryFolder folder;
  const auto said = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"--steps", "0", "--legend-out", folder / "bar.svg"});
    const CommandResult result = render(more);
    CHECK(result.exit_code == 2);
    return result.err;
  };
  CHECK_THAT(said({"--hash"}), Contains("--legend-out: has no picture to explain; expected --out FILE.png beside it"));
  CHECK_THAT(said({"--out", folder / "p.png"}), Contains("--legend-out: has no colors to explain"));
  CHECK(!std::filesystem::exists(folder / "bar.svg"));
  CHECK(render({"--steps", "2", "--color", "von_mises", "--out", folder / "p.png", "--legend-out", folder / "bar.svg"})
            .exit_code == 0);
  CHECK_THAT(read_file(folder / "bar.svg"), Contains("Von Mises stress"));
}
