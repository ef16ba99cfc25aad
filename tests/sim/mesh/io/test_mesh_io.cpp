// Every format and variant, read and written; and the common handling of bad files.
// Covers: formats, scanner, tag_map, sim/mesh/io/gmsh/gmsh_write
// Covers: sim/mesh/io/vtk/vtk_legacy_write, sim/mesh/io/vtk/vtu_write
#include "sim/mesh/io/mesh_io.h"

#include <catch2/catch.hpp>
#include <fstream>

#include "base/error.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/mesh_formats.h"
#include "tests/support/meshes/samples.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

bool mentions(const std::vector<std::string>& notes, const std::string& text) {
  for (const std::string& note : notes) {
    if (note.find(text) != std::string::npos) return true;
  }
  return false;
}

/// From memory if one file is enough: the file system would take most of the time of these tests.
MeshFile read(const TemporaryFolder& folder, const MeshSample& sample) {
  if (!sample.node_content.empty()) return read_mesh(write_sample(folder, sample));
  return read_mesh_content(folder / sample.file, sample.content);
}

}  // namespace

TEST_CASE("every format and variant gives the same mesh", "[mesh_io]") {
  const TemporaryFolder folder;
  for (const MeshSample& sample : all_samples()) {
    INFO(sample.file << ", " << sample.format);
    const MeshFile file = read_mesh(write_sample(folder, sample));
    check_sample(file, sample);
    if (sample.format.starts_with("Gmsh") || sample.format.starts_with("VT")) {
      CHECK(file.ignored.points == 1);
      CHECK(file.ignored.lines == 1);
      CHECK(file.ignored.triangles == 1);
    }
    CHECK(file.ignored.others == 0);
  }
}

TEST_CASE("the format is detected from the content, for any extension", "[mesh_io]") {
  const TemporaryFolder folder;
  for (MeshSample sample : all_samples()) {
    if (!sample.node_content.empty()) continue;  // the names of the two files matter
    INFO(sample.file);
    for (const std::string ending : {".dat", ".msh", ".node", ""}) {
      sample.file = "mesh" + ending;
      check_sample(read_mesh(write_sample(folder, sample)), sample);
    }
    sample.content = "\xef\xbb\xbf" + sample.content;  // UTF-8 byte order mark
    CHECK(read_mesh(write_sample(folder, sample)).format == sample.format);
  }
}

TEST_CASE("TetGen files may begin with a byte order mark", "[mesh_io]") {
  const TemporaryFolder folder;
  for (MeshSample sample : other_samples()) {
    if (sample.node_content.empty()) continue;
    sample.content = "\xef\xbb\xbf" + sample.content;
    sample.node_content = "\xef\xbb\xbf" + sample.node_content;
    check_sample(read_mesh(write_sample(folder, sample)), sample);
  }
}

TEST_CASE("writing and reading back keeps everything that the format supports", "[mesh_io]") {
  const TemporaryFolder folder;
  TetMesh mesh = sample_mesh();
  mesh.positions[5] = {1.0 / 3, -2.2250738585072014e-308, 1.7976931348623157e308};  // digits, tiny, huge
  mesh.groups["with <odd> & 100 % \xc3\xa9"] = {1, 5};
  for (const std::string name : {"a.msh", "a.vtk", "a.vtu", "a.mesh", "a.node", "b.ele", "UPPER.MSH"}) {
    INFO(name);
    write_mesh(folder / name, mesh);
    const TetMesh back = read_mesh(folder / name).mesh;
    CHECK(back.positions == mesh.positions);
    CHECK(back.tets == mesh.tets);
    CHECK(back.regions == mesh.regions);
    const std::string ending = name.substr(2);
    if (ending == "msh" || ending == "vtk" || ending == "vtu") {
      CHECK(back.region_names == mesh.region_names);
      CHECK(back.groups == mesh.groups);
    }
  }
}

TEST_CASE("writing works without regions, and refuses what a format does not support", "[mesh_io]") {
  const TemporaryFolder folder;
  TetMesh mesh = sample_mesh();
  mesh.regions.clear();
  mesh.region_names.clear();
  mesh.groups.clear();
  for (const std::string name : {"a.msh", "a.vtk", "a.vtu", "a.mesh", "a.node", "a.inp"}) {
    INFO(name);
    write_mesh(folder / name, mesh);
    const TetMesh back = read_mesh(folder / name).mesh;
    CHECK(back.tets == mesh.tets);
    CHECK(back.regions == std::vector<int>{0, 0});
    CHECK(back.groups.empty());
  }

  const auto error_of_writing = [&](const std::string& name) -> std::string {
    try {
      write_mesh(folder / name, mesh);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const std::string prefix = folder.path().string() + "/";
  CHECK(error_of_writing("a.stl") == prefix +
                                         "a.stl: cannot be written: its ending names no mesh format; expected .msh, "
                                         ".vtk, .vtu, .node, .ele, .mesh or .inp");
  CHECK(error_of_writing("none/a.msh") ==
        prefix + "none/a.msh: no such folder " + prefix + "none; expected an existing folder");
  mesh.regions = {-1, 2};
  CHECK(error_of_writing("b.msh") == prefix +
                                         "b.msh: region -1 cannot be a physical group; expected 0 or more in a .msh "
                                         "file; .vtu, .vtk and .mesh hold any number");
  CHECK_FALSE(fs::exists(folder / "b.msh"));
  for (const std::string name : {"b.vtk", "b.vtu", "b.mesh", "b.node"}) {
    INFO(name);
    write_mesh(folder / name, mesh);
    CHECK(read_mesh(folder / name).mesh.regions == mesh.regions);
  }
  mesh.regions = {1, 2};
  mesh.groups["two \"words\""] = {0};
  CHECK(error_of_writing("c.msh") ==
        prefix + "c.msh: name 'two \"words\"' has a quote or a line break; expected none in a .msh file");
}

TEST_CASE("a file that is no mesh is refused in one line", "[mesh_io]") {
  const std::string formats = "; expected one of " + listed_formats();
  CHECK(error_of("a.msh", "") == "a.msh: is empty" + formats);
  CHECK(error_of("a.msh",
                 "\x7f"
                 "ELF\x02\x01\x01\n\n\xff") ==
        "a.msh: is not a mesh format that fascia reads (begins with '\\x7fELF\\x02\\x01\\x01\\x0a\\x0a\\xff')" +
            formats);
  CHECK(error_of("a.txt", "12 3 4\n") ==
        "a.txt: is not a mesh format that fascia reads (begins with '12 3 4\\x0a')" + formats);
  CHECK(error_of("a.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n") ==
        "a.off: is a surface of 1 face without tets; expected a tetrahedral mesh");
  CHECK(error_of("a.xml", "<svg/>") == "a.xml:1: svg: is not a VTK file; expected VTKFile");

  const TemporaryFolder folder;
  CHECK_THROWS_WITH(read_mesh(folder / "none.msh"),
                    folder.path().string() + "/none.msh: no such file; expected a readable file");
  CHECK_THROWS_WITH(read_mesh(folder.path()), folder.path().string() + ": is a directory; expected a file");
  CHECK_THROWS_WITH(read_mesh("/dev/zero"), "/dev/zero: is a device; expected a file");
}

// A file cut at any byte is either refused, or read as the whole mesh if only data after the mesh is missing (in VTK
// files that may be the regions). If a number at the end may be truncated unnoticed, a note says so.
TEST_CASE("a file truncated at any byte never crashes, never hangs, never gives another mesh", "[mesh_io]") {
  const TemporaryFolder folder;
  for (const MeshSample& sample : all_samples()) {
    INFO(sample.file << ", " << sample.format);
    const TetMesh whole = read_mesh(write_sample(folder, sample)).mesh;
    const bool vtk = sample.format.starts_with("VTK legacy");
    const std::vector<int> no_regions(whole.tets.size(), 0);
    std::size_t refused = 0;
    for (const bool of_node : {false, true}) {
      const std::size_t size = of_node ? sample.node_content.size() : sample.content.size();
      for (std::size_t length = 0; length < size; ++length) {
        MeshSample cut = sample;
        (of_node ? cut.node_content : cut.content).resize(length);
        if (of_node && length == 0) cut.node_content = " ";
        CAPTURE(of_node, length);
        try {
          const MeshFile file = read(folder, cut);
          const bool regions = file.mesh.regions == whole.regions || (vtk && file.mesh.regions == no_regions);
          if (file.mesh.positions == whole.positions && file.mesh.tets == whole.tets && regions) continue;
          CHECK(mentions(file.notes, "cut off"));
        } catch (const Error& error) {
          ++refused;
          const std::string text = error.what();
          CAPTURE(text);
          CHECK(text.starts_with(folder.path().string()));
          CHECK(text.find('\n') == std::string::npos);
          CHECK(text.find("; ") != std::string::npos);
        }
      }
    }
    CHECK(refused > sample.content.size() / 2);
  }
}

TEST_CASE("no wrong byte crashes a reader or makes it hang", "[mesh_io]") {
  const TemporaryFolder folder;
  for (const MeshSample& sample : all_samples()) {
    INFO(sample.file << ", " << sample.format);
    std::size_t refused = 0;
    for (std::size_t at = 0; at < sample.content.size(); ++at) {
      for (const char wrong : {'\0', '\xff', '9', '\n'}) {
        MeshSample bad = sample;
        bad.content[at] = wrong;
        CAPTURE(at, wrong);
        try {
          const MeshFile file = read(folder, bad);
          REQUIRE(file.mesh.regions.size() == file.mesh.tets.size());
          bool sound = true;
          for (const Tet& tet : file.mesh.tets) {
            for (const std::uint32_t v : tet) sound &= v < file.mesh.positions.size();
          }
          for (const Eigen::Vector3d& x : file.mesh.positions) sound &= x.allFinite();
          REQUIRE(sound);
        } catch (const Error&) {
          ++refused;
        }
      }
    }
    CHECK(refused > sample.content.size() / 4);
  }
}

TEST_CASE("names that a format cannot store are reported", "[mesh_io]") {
  TetMesh mesh = sample_mesh();
  mesh.region_names = {{3, "left part"}};
  mesh.groups = region_groups(mesh);
  mesh.groups["clamp"] = {0, 1, 2};
  for (const char* name : {"m.msh", "m.vtk", "m.vtu"}) CHECK(names_left_out(name, mesh).empty());
  CHECK(names_left_out("m.MESH", mesh) ==
        ".mesh holds the numbers of regions, no names and no groups. Left out: region 3 left part, group clamp.");
  CHECK(names_left_out("m.node", mesh).starts_with(".node holds"));
  mesh.region_names.clear();
  mesh.groups = region_groups(mesh);
  CHECK(names_left_out("m.mesh", mesh).empty());
}
