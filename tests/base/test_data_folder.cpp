// The folder of the program's data: the order of the search, and a folder set by the user.
#include "base/data_folder.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/support/support.h"

using namespace fascia;
namespace fs = std::filesystem;

TEST_CASE("data are beside the program, in share of its prefix, in the source tree, and first where the user says") {
  const char* before = std::getenv("FASCIA_DATA_DIR");
  const std::string kept = before ? before : "";
  unsetenv("FASCIA_DATA_DIR");
  const fs::path beside = fs::read_symlink("/proc/self/exe").parent_path();
  const std::vector<fs::path> expected{beside, beside.parent_path() / "share/fascia",
                                       beside.parent_path().parent_path() / "share/fascia", test::source_dir()};
  CHECK(data_folders() == expected);
  setenv("FASCIA_DATA_DIR", "/some/where", 1);
  const std::vector<fs::path> folders = data_folders();
  REQUIRE(folders.size() == 5);
  CHECK(folders.front() == "/some/where");
  CHECK(std::equal(expected.begin(), expected.end(), folders.begin() + 1));
  if (before)
    setenv("FASCIA_DATA_DIR", kept.c_str(), 1);
  else
    unsetenv("FASCIA_DATA_DIR");
}

TEST_CASE("assets are beside the shaders, or in the chosen folder") {
  const test::TemporaryFolder folder;
  CHECK(holds_shaders(test::source_dir()));
  fs::create_directories(folder / "shaders");
  CHECK_FALSE(holds_shaders(folder.path()));  // the shaders of another program
  fs::create_directories(folder / "shaders/sim");
  CHECK(holds_shaders(folder.path()));
  CHECK_FALSE(holds_shaders(folder / "none"));

  CHECK(fs::exists(asset_folder() / "meshes/cube.msh"));
  set_data_folder(folder.path());
  CHECK(asset_folder() == folder / "assets");
  set_data_folder({});
  CHECK(fs::exists(asset_folder() / "meshes/cube.msh"));
}
