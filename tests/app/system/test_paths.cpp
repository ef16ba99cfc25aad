// The folder of the program's data.
#include "app/system/paths.h"

#include <catch2/catch.hpp>

#include "base/data_folder.h"
#include "base/error.h"
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
