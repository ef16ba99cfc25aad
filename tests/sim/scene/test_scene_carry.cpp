// Scenes that carry their files: the names of the files, the kept data, and the files left out.
#include "sim/scene/scene_carry.h"

#include <catch2/catch.hpp>

#include "base/deflate.h"
#include "base/error.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using test::TemporaryFolder;

namespace {

/// A scene of two bodies with meshes at these paths of a folder, and the reader's records of the files.
struct Sample {
  TemporaryFolder folder;
  Scene scene;
  std::vector<ReadFile> read;
  Sample(const std::string& first, const std::string& second) {
    scene.file = folder / "s.json";
    add(first, "content of the first");
    add(second, "content of the second one");
  }
  void add(const std::string& path, const std::string& content) {
    const std::filesystem::path place = folder / path;
    std::filesystem::create_directories(place.parent_path());
    write_file(place, content);
    const std::string key = "bodies[" + std::to_string(scene.bodies.size()) + "].mesh";
    scene.bodies.emplace_back().mesh = path;
    read.push_back({key, "", {path, content.size(), content_hash(content), nullptr}, place});
  }
};

}  // namespace

TEST_CASE("a scene with known files has their sizes and hashes, and none of their content") {
  Sample s("a.msh", "b.msh");
  const Scene known = with_known_files(s.scene, s.read);
  REQUIRE(known.files.size() == 2);
  CHECK(known.files[0].path == "a.msh");
  CHECK(known.files[0].size == 20);
  CHECK(known.files[0].hash == content_hash("content of the first"));
  CHECK_FALSE(known.files[0].deflated);
  CHECK(known.files[1].path == "b.msh");
  CHECK_FALSE(known.carries("a.msh"));
  CHECK(known.bodies == s.scene.bodies);
}

TEST_CASE("a scene that carries its files has them by their names, with their content") {
  Sample s("meshes/a.msh", "meshes/b.msh");
  const Scene whole = self_contained(s.scene, s.read);
  CHECK(whole.bodies[0].mesh == "a.msh");
  CHECK(whole.bodies[1].mesh == "b.msh");
  REQUIRE(whole.carries("b.msh"));
  CHECK(carried_content(*whole.recorded("b.msh"), "s.json") == "content of the second one");
  CHECK(inflated(*s.read[0].file.deflated, 20) == "content of the first");  // kept for the next time
  std::filesystem::remove(s.folder / "meshes/a.msh");
  CHECK(self_contained(s.scene, s.read).files == whole.files);
  CHECK_FALSE(with_known_files(s.scene, s.read).files[0].deflated);
}

TEST_CASE("files of one name in several folders get numbers for these") {
  Sample s("left/m.msh", "right/m.msh");
  const Scene whole = self_contained(s.scene, s.read);
  CHECK(whole.bodies[0].mesh == "1/m.msh");
  CHECK(whole.bodies[1].mesh == "2/m.msh");
  CHECK(carried_content(*whole.recorded("1/m.msh"), "") == "content of the first");
  CHECK(carried_content(*whole.recorded("2/m.msh"), "") == "content of the second one");
}

TEST_CASE("a file that another file names is beside it, and is carried once") {
  Sample s("meshes/a.node", "meshes/a.node");
  s.read.push_back({"bodies[0].mesh", "a.ele", {"", 3, content_hash("abc"), nullptr}, s.folder / "meshes/a.ele"});
  write_file(s.folder / "meshes/a.ele", "abc");
  s.read[0] = s.read[1];  // both records are of the same file
  s.read[0].key = "bodies[0].mesh";
  const Scene whole = self_contained(s.scene, s.read);
  REQUIRE(whole.files.size() == 2);
  CHECK(whole.files[0].path == "a.node");
  CHECK(whole.files[1].path == "a.ele");
  CHECK(carried_content(whole.files[1], "") == "abc");
}

TEST_CASE("missing, changed or too large files are not carried, and the reason is stated") {
  Sample s("a.msh", "b.msh");
  write_file(s.folder / "b.msh", "something of another size");
  CHECK_THROWS_WITH(self_contained(s.scene, s.read), Catch::Contains("b.msh: has changed since it was opened; "));
  CHECK_FALSE(self_contained_if_possible(s.scene, s.read).carries("b.msh"));
  CHECK(self_contained_if_possible(s.scene, s.read).recorded("b.msh") != nullptr);
  std::filesystem::remove(s.folder / "b.msh");
  CHECK_THROWS_WITH(self_contained(s.scene, s.read), Catch::Contains("b.msh: no such file"));

  Sample large("a.msh", "b.msh");
  large.read[1].file.size = kMostCarried + 1;
  CHECK_THROWS_WITH(self_contained(large.scene, large.read),
                    Catch::EndsWith("b.msh: has 1073741825 bytes; expected at most 1073741824 of a file that a scene "
                                    "carries"));
}

TEST_CASE("files beyond the requested total size are not carried") {
  Sample s("a.msh", "b.msh");  // 20 and 25 bytes
  CHECK_FALSE(self_contained_if_possible(s.scene, s.read, 44).carries("a.msh"));
  CHECK(self_contained_if_possible(s.scene, s.read, 45).carries("a.msh"));
}
