#include "render/target/image.h"

#include <catch2/catch.hpp>

#include <fstream>

#include "base/error.h"
#include "base/file.h"
#include "tests/support/support.h"

namespace fascia {
namespace {

using Catch::Matchers::Contains;

Image gradient(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int value : {x * 7, y * 5, x * y, 255 - x}) image.rgba.push_back(static_cast<std::uint8_t>(value));
  return image;
}

template <class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no Error was thrown";
}

}  // namespace

TEST_CASE("a picture is read back from PNG unchanged, with its metadata") {
  const test::TemporaryFolder folder;
  const Image image = gradient(37, 23);
  const Metadata metadata = {{"Software", "fascia 0.1"},
                             {"scene", "{\n  \"name\": \"liver\"\n}"},
                             {"Author", "J\xc3\xbcrgen \xe2\x80\x94 \xe8\x82\x9d"},  // UTF-8
                             {"empty", ""}};
  write_png(folder / "a.png", image, metadata);
  const Image back = read_png(folder / "a.png");
  CHECK(back.width == 37);
  CHECK(back.height == 23);
  CHECK(back.rgba == image.rgba);
  CHECK(read_png_metadata(folder / "a.png") == metadata);
  const std::string file = read_file(folder / "a.png");
  CHECK(file.find("tEXtSoftware") != std::string::npos);
  CHECK(file.find("iTXtAuthor") != std::string::npos);

  write_png(folder / "b.png", image);
  CHECK(read_png_metadata(folder / "b.png").empty());
  CHECK(read_png(folder / "b.png").rgba == image.rgba);
}

TEST_CASE("equal pictures are equal files") {
  const test::TemporaryFolder folder;
  write_png(folder / "a.png", gradient(64, 48), {{"a", "1"}});
  write_png(folder / "b.png", gradient(64, 48), {{"a", "1"}});
  CHECK(read_file(folder / "a.png") == read_file(folder / "b.png"));
}

TEST_CASE("Latin-1 text of other programs is read as UTF-8") {
  const test::TemporaryFolder folder;
  write_png(folder / "a.png", gradient(2, 2), {{"name", "Jurgen"}});
  std::string file = read_file(folder / "a.png");
  file[file.find("Jurgen") + 1] = '\xfc';
  std::ofstream(folder / "a.png", std::ios::binary) << file;
  CHECK_THAT(error_of([&] { read_png_metadata(folder / "a.png"); }), Contains("wrong checksum"));
  // CRC-32 of "tEXtname\0J\xfcrgen", by Python's zlib.crc32.
  const std::string crc = "\xfe\xa5\x93\x26";
  const std::size_t end = file.find("rgen") + 4;
  file.replace(end, 4, crc);
  std::ofstream(folder / "a.png", std::ios::binary) << file;
  CHECK(read_png_metadata(folder / "a.png") == Metadata{{"name", "J\xc3\xbcrgen"}});
}

TEST_CASE("a PNG that is cut at any byte, or has any byte changed, is an Error and not a crash") {
  const test::TemporaryFolder folder;
  write_png(folder / "a.png", gradient(9, 5), {{"key", "value"}, {"other", "\xc3\xbc"}});
  const std::string whole = read_file(folder / "a.png");
  const std::string path = folder / "bad.png";
  for (std::size_t size = 0; size < whole.size(); ++size) {
    std::ofstream(path, std::ios::binary) << whole.substr(0, size);
    CAPTURE(size);
    CHECK_THROWS_AS(read_png(path), Error);
    CHECK_THROWS_AS(read_png_metadata(path), Error);
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x41);
    std::ofstream(path, std::ios::binary) << changed;
    CAPTURE(at);
    CHECK_THROWS_AS(read_png(path), Error);  // a checksum or the signature covers every byte
  }
}

TEST_CASE("a file that is no picture is named") {
  const test::TemporaryFolder folder;
  CHECK_THAT(error_of([&] { read_png(folder / "none.png"); }), Contains("none.png: no such file"));
  std::ofstream(folder / "text.png") << "not a picture";
  CHECK_THAT(error_of([&] { read_png(folder / "text.png"); }),
             Contains("text.png: no PNG signature; expected a PNG picture"));
  const Image image = gradient(4, 4);
  CHECK_THAT(error_of([&] { write_png(folder / "gone" / "a.png", image); }), Contains("no such folder"));
  CHECK_THAT(error_of([&] {
               write_png(folder / "a.png", {4, 4, {1, 2, 3}});
             }),
             Contains("picture of 4 x 4 with 3 bytes"));
  CHECK_THAT(error_of([&] { write_png(folder / "a.png", {0, 0, {}}); }), Contains("picture of 0 x 0"));
  CHECK_THAT(error_of([&] {
               write_png(folder / "a.png", image, {{std::string(80, 'k'), "v"}});
             }),
             Contains("metadata keyword"));
  CHECK_THAT(error_of([&] { write_png(folder / "a.png", image, {{"", "v"}}); }), Contains("metadata keyword"));
  CHECK_THAT(error_of([&] {
               write_png(folder / "a.png", image, {{"k", std::string("a\0b", 3)}});
             }),
             Contains("zero byte"));
  CHECK_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST_CASE("a header that claims a huge picture is refused before memory is allocated") {
  const test::TemporaryFolder folder;
  write_png(folder / "a.png", gradient(4, 4));
  std::string file = read_file(folder / "a.png");
  // 8192 x 8192, and the CRC-32 of that IHDR chunk, by Python's zlib.crc32.
  file.replace(16, 8, std::string("\0\0\x20\0\0\0\x20\0", 8));
  file.replace(29, 4, "\x72\xaa\xca\x59");
  std::ofstream(folder / "a.png", std::ios::binary) << file;
  CHECK_THAT(error_of([&] { read_png(folder / "a.png"); }), Contains("claims 8192 x 8192 pixels"));
}

TEST_CASE("the difference of pictures is the mean and the share of pixels beyond the bound") {
  Image a{10, 10, std::vector<std::uint8_t>(400, 100)}, b = a;
  CHECK(difference(a, b).mean == 0);
  CHECK(difference(a, b).share == 0);
  b.rgba[0] = 109;  // 9 of 255 is beyond the bound of 8
  b.rgba[5] = 92;   // 8 of 255 is not
  const ImageDifference d = difference(a, b);
  CHECK(d.mean == Approx(17.0 / 255 / 400));
  CHECK(d.share == Approx(1.0 / 100));
  REQUIRE(d.picture.rgba.size() == 400);
  CHECK(d.picture.rgba[0] == 72);
  CHECK(d.picture.rgba[5] == 64);
  CHECK(d.picture.rgba[3] == 255);
  CHECK(difference(a, b, 0).share == Approx(2.0 / 100));

  const Image black{2, 1, std::vector<std::uint8_t>(8, 0)}, white{2, 1, std::vector<std::uint8_t>(8, 255)};
  CHECK(difference(black, white).mean == 1);
  CHECK(difference(black, white).share == 1);
  CHECK(difference(black, a).mean == 1);
  CHECK(difference(black, a).share == 1);
}

}  // namespace fascia
