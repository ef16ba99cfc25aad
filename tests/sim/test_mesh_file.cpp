// Whole files: what is written is complete or not there.
#include "sim/file.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <thread>

#include "sim/error.h"
#include "tests/support/support.h"

using namespace fascia;
using fascia::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

std::size_t entries(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("a file reads back as it was written", "[file]") {
  const TemporaryFolder folder;
  const std::string content =
      std::string("binary \0 \xff\r\n", 12) + std::string(200000, 'x');  // beyond one block
  write_file(folder / "a", content);
  CHECK(read_file(folder / "a") == content);
  write_file(folder / "a", "");
  CHECK(read_file(folder / "a").empty());
  CHECK(entries(folder) == 1);
}

TEST_CASE("a pipe can be read as often as a file", "[file]") {
  const TemporaryFolder folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  const std::string content(200000, 'x');  // more than a pipe holds
  std::jthread writer([&] { std::ofstream(folder / "pipe") << content; });
  CHECK(read_file(folder / "pipe") == content);
  CHECK(read_file(folder / "pipe") == content);
}

TEST_CASE("reading says what is wrong", "[file]") {
  const TemporaryFolder folder;
  const std::string prefix = folder.path().string();
  CHECK_THROWS_WITH(read_file(folder / "none"), prefix + "/none: no such file; expected a readable file");
  CHECK_THROWS_WITH(read_file(folder.path()), prefix + ": is a directory; expected a file");
  CHECK_THROWS_WITH(read_file("/dev/zero"), "/dev/zero: is a device; expected a file");
}

TEST_CASE("a writer that fails leaves the old file and nothing else", "[file]") {
  const TemporaryFolder folder;
  write_file(folder / "a", "old");
  CHECK_THROWS_WITH(write_file(folder / "a",
                               [](std::ostream& out) {
                                 out << "half";
                                 throw Error("a: failed midway");
                               }),
                    "a: failed midway");
  CHECK(read_file(folder / "a") == "old");
  CHECK(entries(folder) == 1);
}

TEST_CASE("writing says what is wrong", "[file]") {
  const TemporaryFolder folder;
  const std::string prefix = folder.path().string();
  CHECK_THROWS_WITH(write_file(folder / "none/a", "x"),
                    prefix + "/none/a: no such folder " + prefix + "/none; expected an existing folder");
  CHECK_THROWS_WITH(write_file(folder.path(), "x"), prefix + ": is a directory; expected a file name");
  fs::create_symlink("/dev/full",
                     folder / "full");  // a link, so that a mistake here cannot replace the device
  CHECK_THROWS_WITH(
      write_file(folder / "full", std::string(100000, 'x')),
      prefix + "/full: writing failed: No space left on device; expected a device that takes data");
}

TEST_CASE("a device stays a device and a link stays a link", "[file]") {
  const TemporaryFolder folder;
  fs::create_symlink("/dev/null", folder / "null");
  write_file(folder / "null", "x");
  CHECK(fs::is_character_file(folder / "null"));
  write_file(folder / "target", "old");
  fs::create_symlink("target", folder / "link");
  write_file(folder / "link", "new");
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(read_file(folder / "target") == "new");
  CHECK(entries(folder) == 3);
}

TEST_CASE("names", "[file]") {
  const fs::path name = temporary_name("some/where/out.vtu");
  CHECK(name.parent_path() == "some/where");
  CHECK(name.extension() == ".vtu");
  CHECK(name.filename() != "out.vtu");
  CHECK(lower_ending("a/Beam.MSH") == ".msh");
  CHECK(lower_ending("a.b/beam").empty());
}
