// Whole files: a written file is complete or does not exist.
// Covers: file_read
#include "base/file.h"

#include <sys/stat.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <fstream>
#include <thread>

#include "base/error.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/surface/surface_mesh.h"
#include "tests/support/support.h"

using namespace fascia;
using fascia::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

std::size_t entries(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("a file reads back as it was written", "[file]") {
  const TemporaryFolder folder;
  const std::string content = std::string("binary \0 \xff\r\n", 12) + std::string(200000, 'x');  // beyond one block
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

TEST_CASE("reading reports errors", "[file]") {
  const TemporaryFolder folder;
  const std::string prefix = folder.path().string();
  CHECK_THROWS_WITH(read_file(folder / "none"), prefix + "/none: no such file; expected a readable file");
  CHECK_THROWS_WITH(read_file(folder.path()), prefix + ": is a directory; expected a file");
  CHECK_THROWS_WITH(read_file("/dev/zero"), "/dev/zero: is a device; expected a file");
}

TEST_CASE("a file that is mostly a hole is refused by its size, regardless of the data before the hole", "[file]") {
  const TemporaryFolder folder;
  const std::string gmsh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n";
  for (const auto& [name, head] : std::vector<std::pair<std::string, std::string>>{
           {"zeros.msh", ""},
           {"head.msh", gmsh},
           {"many.msh", "$MeshFormat\n2.2 1 8\n" + std::string("\1\0\0\0", 4) + "$EndMeshFormat\n$Nodes\n300000000\n"},
           {"head.obj", "v 0 0 0\nv 1 0 0\n"},
           {"head.vtk", "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 800000000 float\n"},
           {"head.vtu", "<VTKFile type=\"UnstructuredGrid\">"},
           {"head.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n1000000000\n"},
           {"head.node", "4 3 0 0\n"}}) {
    write_file(folder / name, head);
    fs::resize_file(folder / name, std::uintmax_t{1} << 30);
    std::string error;
    try {
      name.ends_with(".obj") ? static_cast<void>(read_obj(folder / name)) : static_cast<void>(read_mesh(folder / name));
    } catch (const Error& refused) {
      error = refused.what();
    }
    std::printf("%s\n", fs::path(error).filename().c_str());
    CHECK_THAT(error, Catch::StartsWith((folder / name).string() + ": is 1.1 GB long, but only ") &&
                          Catch::EndsWith(" of them are stored, the rest is a hole; expected a complete file"));
  }
  // Small holes are read as zeros, and so are large ones beside more data.
  write_file(folder / "small", "x");
  fs::resize_file(folder / "small", 1 << 20);
  CHECK(read_file(folder / "small").size() == 1 << 20);
  write_file(folder / "half", std::string(40 << 20, 'x'));
  fs::resize_file(folder / "half", 70 << 20);
  CHECK(read_file(folder / "half") == std::string(40 << 20, 'x') + std::string(30 << 20, '\0'));
}

TEST_CASE("reading reports its progress, and ends when the report throws", "[file]") {
  struct Enough {};
  const TemporaryFolder folder;
  write_file(folder / "a", std::string(10 << 20, 'x'));
  std::vector<double> shares;
  read_file(folder / "a", [&](double share, const char*) { shares.push_back(share); });
  std::printf("10 MB: %zu reports\n", shares.size());
  CHECK(shares.size() >= 10);
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(shares.back() == 1);
  CHECK_THROWS_AS(read_file(folder / "a", [&](double, const char*) { throw Enough(); }), Enough);
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK_THROWS_AS(read_file(folder / "pipe", [&](double, const char*) { throw Enough(); }), Enough);
}

TEST_CASE("a pipe without a writer is refused, and a slow writer is waited for", "[file]") {
  const TemporaryFolder folder;
  REQUIRE(mkfifo((folder / "idle").c_str(), 0600) == 0);
  REQUIRE(mkfifo((folder / "slow").c_str(), 0600) == 0);
  CHECK_THROWS_WITH(read_file(folder / "idle"),
                    (folder / "idle").string() +
                        ": is a pipe into which nothing writes; waited 5 s; expected a program that writes into it");
  std::jthread writer([&] {
    std::ofstream out(folder / "slow");
    for (int i = 0; i < 3; ++i) {
      out << "part" << std::flush;
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
    }
  });
  const std::string content = read_file(folder / "slow");
  std::printf("a slow pipe: %s\n", content.c_str());
  CHECK(content == "partpartpart");
}

TEST_CASE("a writer that fails leaves only the old file", "[file]") {
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

TEST_CASE("writing reports errors", "[file]") {
  const TemporaryFolder folder;
  const std::string prefix = folder.path().string();
  CHECK_THROWS_WITH(write_file(folder / "none/a", "x"),
                    prefix + "/none/a: no such folder " + prefix + "/none; expected an existing folder");
  CHECK_THROWS_WITH(write_file(folder.path(), "x"), prefix + ": is a directory; expected a file name");
  fs::create_symlink("/dev/full",
                     folder / "full");  // a link, so that a mistake here cannot replace the device
  CHECK_THROWS_WITH(write_file(folder / "full", std::string(100000, 'x')),
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
