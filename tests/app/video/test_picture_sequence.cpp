// A video as pictures: their names and their content.
#include "app/video/picture_sequence.h"

#include <catch2/catch.hpp>

#include "render/target/image.h"
#include "tests/support/support.h"

using namespace fascia;
using test::TemporaryFolder;

TEST_CASE("a pattern has one place for a number in its file name") {
  const auto check = [](const char* pattern, const std::string& before, const std::string& after, std::size_t digits) {
    const std::optional<PictureNames> names = picture_names(pattern);
    CAPTURE(pattern);
    REQUIRE(names);
    CHECK(names->before == before);
    CHECK(names->after == after);
    CHECK(names->digits == digits);
  };
  check("%d.png", "", ".png", 0);
  check("some%/a_%05d.png", "a_", ".png", 5);
  check("a%3dd.png", "a", "d.png", 3);
  for (const char* wrong : {"", "a.png", "%.png", "%d%d.png", "%x.png", "%5.png", "%-5d.png", "%13d.png", "%5 d.png",
                            "%/a.png", "a%%d.png"}) {
    CAPTURE(wrong);
    CHECK_FALSE(picture_names(wrong));
  }
}

TEST_CASE("frames are numbered from 0 in a folder that is made for them") {
  const TemporaryFolder folder;
  PictureSequence sequence(folder / "new/deep/f%03d.png", {2, 1, 30}, {{"Title", "x"}});
  for (std::uint8_t i = 0; i < 3; ++i) sequence.write({i, 10, 20, 255, 30, 40, 50, 255});
  sequence.finish();
  for (int i = 0; i < 3; ++i) {
    const Image image = read_png(folder / ("new/deep/f00" + std::to_string(i) + ".png"));
    CAPTURE(i);
    CHECK(image.width == 2);
    CHECK(image.height == 1);
    CHECK(image.rgba == std::vector<std::uint8_t>{static_cast<std::uint8_t>(i), 10, 20, 255, 30, 40, 50, 255});
  }
  CHECK_FALSE(std::filesystem::exists(folder / "new/deep/f003.png"));
  CHECK_THROWS_WITH(PictureSequence(folder / "f.png", {2, 1, 30}, {}),
                    Catch::Contains("f.png: has no place for the number of a picture"));
}
