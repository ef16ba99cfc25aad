// The content of a folder in the dialog.
// Covers: gallery
#include <catch2/catch.hpp>

#include "app/dialogs/folder_listing.h"
#include "app/dialogs/gallery.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("a folder lists folders, then files that fascia opens, by name, ignoring case") {
  const TemporaryFolder folder;
  for (const char* name : {"b.json", "A.msh", "c.OBJ", "notes.txt", ".hidden.json", "d.fascia", "e.ele", "e.node"})
    write_file(folder / name, "");
  std::filesystem::create_directory(folder / "Zebra");
  const auto names = [&](std::size_t kind, const std::string& part = "") {
    std::vector<std::string> list;
    for (const FolderEntry& entry : list_folder(folder.path(), openable_kinds()[kind], part))
      list.push_back(entry.path.filename().string());
    return list;
  };
  CHECK(names(0) == std::vector<std::string>{"Zebra", "A.msh", "b.json", "c.OBJ", "d.fascia", "e.node"});
  CHECK(names(1) == std::vector<std::string>{"Zebra", "b.json"});
  CHECK(names(0, "MS") == std::vector<std::string>{"A.msh"});
  CHECK(list_folder(folder / "nowhere", openable_kinds()[0]).empty());
}

TEST_CASE("the gallery has every shipped scene with a picture and a description") {
  const std::vector<Example> examples = shipped_examples(source_dir() / "assets");
  REQUIRE(examples.size() >= 5);
  CHECK(examples.front().scene.stem() == "liver");
  for (const Example& example : examples) {
    CAPTURE(example.scene);
    CHECK_FALSE(example.title.empty());
    CHECK(example.name.size() < 20);  // fits below its picture
    CHECK_FALSE(example.says.empty());
    CHECK(std::filesystem::exists(example.picture));
  }
  CHECK(shipped_examples(source_dir() / "nowhere").empty());
}
