// The folder of the program's data.
#include "app/system/paths.h"

#include <catch2/catch.hpp>

#include "base/data_folder.h"
#include "base/error.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
namespace fs = std::filesystem;

TEST_CASE("a data folder is the one that is named, or the first that has shaders") {
  CHECK(holds_shaders(find_data_dir("")));
  CHECK(fs::exists(default_scene(find_data_dir(""))));
  const test::TemporaryFolder folder;
  CHECK_THROWS_WITH(find_data_dir(folder.path().string()),
                    "--data-dir " + folder.path().string() + ": has no folder shaders; expected fascia's data folder");
  fs::create_directories(folder / "shaders/sim");
  CHECK(find_data_dir(folder.path().string()) == folder.path());
  CHECK(asset_folder() == folder / "assets");  // the root of "assets:" in scenes
  set_data_folder({});
  CHECK(default_scene("/x") == "/x/assets/scenes/liver.json");
}

TEST_CASE("the name of a shipped scene opens it where no file here has that name") {
  const test::TemporaryFolder folder;
  const fs::path shipped = find_data_dir("") / "assets/scenes";
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  CHECK(input_or_shipped("kidney.json", "") == shipped / "kidney.json");
  CHECK(shipped_note("kidney.json", shipped / "kidney.json") ==
        "kidney.json: no such file here; opened the shipped scene " + (shipped / "kidney.json").string());
  for (const char* own : {"nothing.json", "./kidney.json", "scenes/kidney.json", "kidney.obj", "-", ""}) {
    CAPTURE(own);
    CHECK(input_or_shipped(own, "") == own);
    CHECK(shipped_note(own, own).empty());
  }
  write_file("kidney.json", "");
  fs::create_symlink("gone.json", "cube.json");
  CHECK(input_or_shipped("kidney.json", "") == "kidney.json");
  CHECK(input_or_shipped("cube.json", "") == "cube.json");
  fs::current_path(before);
}
