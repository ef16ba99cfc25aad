// The shipped scenes against pictures made before, on both software contexts. Goldens are updated only by
// scripts/update_goldens.sh. A failure leaves the actual picture and the difference in ./golden_failures.
//
// Bounds: on one Mesa version and processor the pictures are bit-identical. Other vector widths or shader compilers round
// differently, which moves an edge by less than a pixel: few pixels change much (share), the average hardly (mean).
#include <catch2/catch.hpp>
#include <filesystem>

#include "render/image.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr double max_mean = 0.5 / 255;

struct Golden {
  std::string name, scene;
  std::vector<std::string> options;
  double max_share = 0.005;
};

const std::vector<Golden>& goldens() {
  static const std::vector<Golden> list{
      {"liver", "liver.json", {"--steps", "30"}},
      {"beam_wireframe", "beam.json", {"--steps", "30", "--wireframe"}},
      {"ligament_stress", "ligament.json", {"--steps", "30", "--color", "von_mises"}},
      {"inclusion_strain", "inclusion.json", {"--steps", "30", "--color", "strain"}},
      {"cube_panels", "cube.json", {"--steps", "30", "--ui"}, 0.002},  // one wrong word in a panel is 0.003
      {"liver_section", "liver.json",
       {"--steps", "30", "--color", "largest_stress", "--set", "display.section.normal=[0,0,1]", "--set", "display.background=white"}},
      {"inclusion_tets", "inclusion.json",
       {"--steps", "30", "--color", "region", "--set", "display.tets.shrink=0.8", "--set", "display.section.normal=[0,0,1]", "--set",
        "display.background=transparent"}},
      {"cube_rest", "cube.json", {"--steps", "0", "--samples", "1"}},
  };
  return list;
}

}  // namespace

TEST_CASE("shipped scenes look as they did", "[golden]") {
  const std::string context = GENERATE("osmesa", "egl");
  for (const Golden& golden : goldens()) {
    CAPTURE(context, golden.name);
    const TemporaryFolder folder;
    const std::filesystem::path picture = folder / (golden.name + ".png");
    std::vector<std::string> arguments{"render", (source_dir() / "assets/scenes" / golden.scene).string(),
                                       "--context", context, "--size", "320x240", "--quiet", "--out", picture.string()};
    arguments.insert(arguments.end(), golden.options.begin(), golden.options.end());
    const CommandResult result = run_fascia(arguments);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    const std::filesystem::path expected = test_dir() / "golden" / (golden.name + ".png");
    REQUIRE(std::filesystem::exists(expected));
    const Image actual = read_png(picture);
    const ImageDifference d = difference(actual, read_png(expected));
    CAPTURE(d.mean, d.share);
    CHECK(d.mean <= max_mean);
    CHECK(d.share <= golden.max_share);
    if (d.mean > max_mean || d.share > golden.max_share) {
      std::filesystem::create_directories("golden_failures");
      write_png("golden_failures/" + golden.name + "_" + context + ".png", actual);
      write_png("golden_failures/" + golden.name + "_" + context + "_difference.png", d.picture);
    }
  }
}

TEST_CASE("a golden of another scene does not pass", "[golden]") {
  const Image liver = read_png(test_dir() / "golden/liver.png"), beam = read_png(test_dir() / "golden/beam_wireframe.png");
  const ImageDifference d = difference(liver, beam);
  CAPTURE(d.mean, d.share);
  CHECK(d.mean > max_mean);
  for (const Golden& golden : goldens()) CHECK(d.share > golden.max_share);
}
