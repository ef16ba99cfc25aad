// Symbolic links as outputs: they are kept, and their targets are replaced or created, or the reason against it is
// reported.
#include <catch2/catch.hpp>

#include "app/cli/output_files.h"
#include "app/cli/usage_error.h"
#include "base/error.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

}  // namespace

TEST_CASE("a dangling link is followed, and its target created", "[links]") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "there");
  const struct {
    std::string link;
    fs::path leads_to;
  } cases[] = {{"absolute.txt", folder / "there/absolute.txt"},
               {"relative.txt", "there/relative.txt"},
               {"chain.txt", "next.txt"}};
  fs::create_symlink("there/chain.txt", folder / "next.txt");
  for (const auto& [name, leads_to] : cases) {
    const fs::path link = folder / name, target = folder / "there" / name;
    fs::create_symlink(leads_to, link);
    for (const char* content : {"made", "replaced"}) {
      write_file(link, content);
      CAPTURE(name, content);
      CHECK(fs::is_symlink(link));
      CHECK(fs::read_symlink(link) == leads_to);
      REQUIRE(fs::is_regular_file(target));
      CHECK(read_file(target) == content);
    }
  }
  CHECK(fs::is_symlink(folder / "next.txt"));
  CHECK(entries(folder / "there") == 3);  // nothing temporary
  CHECK(entries(folder.path()) == 5);
}

TEST_CASE("a link that leads nowhere is refused and kept", "[links]") {
  const TemporaryFolder folder;
  fs::create_symlink("no/such/folder.csv", folder / "nowhere.csv");
  fs::create_symlink("b.csv", folder / "a.csv");
  fs::create_symlink("a.csv", folder / "b.csv");
  CHECK_THROWS_WITH(require_writable(folder / "nowhere.csv"),
                    Contains("nowhere.csv: links to ") && Contains("no such folder"));
  CHECK_THROWS_WITH(require_writable(folder / "a.csv"), Contains("leads in a circle"));
  for (const char* name : {"nowhere.csv", "a.csv"}) {
    const CommandResult result = run_fascia({"run", cube_path(), "--steps", "1", "--export", (folder / name).string()});
    CAPTURE(name, result.err);
    CHECK(result.exit_code == 1);
    CHECK_THAT(result.err, Contains(name));
    CHECK(fs::is_symlink(folder / name));
  }
  CHECK(entries(folder.path()) == 3);
}

TEST_CASE("a link and the file that it would create are one output", "[links]") {
  const TemporaryFolder folder;
  fs::create_symlink("target.csv", folder / "link.csv");
  CHECK_THROWS_AS(
      require_outputs({{"--a", (folder / "link.csv").string(), {}}, {"--b", (folder / "target.csv").string(), {}}}),
      UsageError);
}

TEST_CASE("every output follows links, including videos of ffmpeg", "[links]") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "there");
  const auto link_to = [&](const std::string& name) {
    fs::create_symlink("there/" + name, folder / name);
    return (folder / name).string();
  };
  const CommandResult run =
      run_fascia({"run", cube_path(), "--quiet", "--context", "osmesa", "--steps", "1", "--export",
                  link_to("state.csv"), "--stats", link_to("stats.json"), "--history", link_to("rows.csv")});
  const CommandResult render =
      run_fascia({"render", cube_path(), "--quiet", "--context", "osmesa", "--time", "0.1", "--size", "64x48", "--out",
                  link_to("shot.png"), "--video", link_to("film.mp4")});
  CAPTURE(run.err, render.err);
  CHECK(run.exit_code == 0);
  CHECK(render.exit_code == 0);
  for (const char* name : {"state.csv", "stats.json", "rows.csv", "shot.png", "film.mp4"}) {
    CAPTURE(name);
    CHECK(fs::is_symlink(folder / name));
    CHECK(fs::is_regular_file(folder / "there" / name));
  }
  CHECK(entries(folder / "there") == 5);
}

TEST_CASE("a video does not replace a device or an input file", "[links]") {
  const TemporaryFolder folder;
  fs::create_symlink("/dev/null", folder / "null.mp4");
  fs::copy(source_dir() / "assets/meshes/cube.msh", folder / "cube.msh");
  fs::create_symlink("cube.msh", folder / "mesh.mp4");
  const std::string before = read_file(folder / "cube.msh");
  for (const char* name : {"null.mp4", "mesh.mp4"}) {
    const CommandResult result = run_fascia({"render", (folder / "cube.msh").string(), "--quiet", "--context", "osmesa",
                                             "--time", "0.1", "--size", "64x48", "--video", (folder / name).string()});
    CAPTURE(name, result.err);
    CHECK(result.exit_code == 2);
    CHECK(fs::is_symlink(folder / name));
  }
  CHECK(fs::is_character_file("/dev/null"));
  CHECK(read_file(folder / "cube.msh") == before);
}
