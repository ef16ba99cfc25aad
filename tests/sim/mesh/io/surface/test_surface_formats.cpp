// STL, PLY and OFF: files written here byte by byte, cut at every byte, and their errors.
// Covers: off, ply, stl
#include <catch2/catch.hpp>

#include "base/error.h"
#include "sim/mesh/io/formats.h"
#include "tests/support/meshes/samples.h"

using namespace fascia;
using namespace fascia::test;

namespace {

const std::vector<Eigen::Vector3d> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.5}};
const std::vector<Triangle> triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

std::string number(double x) { return x == 1.5 ? "1.5" : x == 1 ? "1" : "0"; }

std::string stl_text() {
  std::string text = "solid a tet\n";
  for (const Triangle& t : triangles) {
    text += "  facet normal nan nan nan\n    outer loop\n";
    for (const std::uint32_t v : t)
      text +=
          "      vertex " + number(corners[v][0]) + " " + number(corners[v][1]) + " " + number(corners[v][2]) + "\n";
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid a tet\n";
}

std::string stl_binary() {
  Bytes out;
  out.add_text("solid in the header of a binary file" + std::string(44, ' ')).add(std::uint32_t{4});
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) out.add(0.f);
    for (const std::uint32_t v : t)
      for (int k = 0; k < 3; ++k) out.add(static_cast<float>(corners[v][k]));
    out.add(std::uint16_t{0});
  }
  return out.text;
}

std::string ply_header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty double y\nproperty float z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 4\nproperty uchar quality\n"
         "property list uchar int vertex_indices\nelement note 1\nproperty short size\nend_header\n";
}

std::string ply_text() {
  std::string text = ply_header("ascii");
  for (const auto& x : corners) text += number(x[0]) + " " + number(x[1]) + " " + number(x[2]) + " 255 128 0\n";
  for (const Triangle& t : triangles)
    text += "7 3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  return text + "12\n";
}

std::string ply_binary(bool big) {
  Bytes out(big);
  for (const auto& x : corners)
    out.add(static_cast<float>(x[0]))
        .add(x[1])
        .add(static_cast<float>(x[2]))
        .add(std::uint8_t{255})
        .add(std::uint8_t{128})
        .add(std::uint8_t{0});
  for (const Triangle& t : triangles) {
    out.add(std::uint8_t{7}).add(std::uint8_t{3});
    for (const std::uint32_t v : t) out.add(static_cast<std::int32_t>(v));
  }
  out.add(std::int16_t{12});
  return ply_header(big ? "binary_big_endian" : "binary_little_endian") + out.text;
}

std::string off_text(const std::string& keyword, const std::string& color) {
  std::string text = "# made by hand\n" + keyword + " # surface\n4 4 0\n";
  for (const auto& x : corners) text += number(x[0]) + " " + number(x[1]) + " " + number(x[2]) + color + "\n";
  for (const Triangle& t : triangles)
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + " 255 0 0\n";
  return text;
}

struct Sample {
  std::string name, format, content;
};

std::vector<Sample> samples() {
  return {{"a.stl", "STL ASCII", stl_text()},
          {"a.stl", "STL binary", stl_binary()},
          {"a.ply", "PLY ASCII", ply_text()},
          {"a.ply", "PLY binary", ply_binary(false)},
          {"a.ply", "PLY binary, big-endian", ply_binary(true)},
          {"a.off", "OFF", off_text("OFF", "")},
          {"a.off", "OFF", off_text("COFF", " 255 128 0 255")}};
}

/// The triangles as places, since STL numbers vertices in the order in which triangles meet them.
std::vector<Eigen::Vector3d> places(const MeshFile& file) {
  std::vector<Eigen::Vector3d> out;
  for (const std::uint32_t v : file.faces.corners) out.push_back(file.mesh.positions.at(v));
  return out;
}

std::vector<Eigen::Vector3d> expected_places() {
  std::vector<Eigen::Vector3d> out;
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t) out.push_back(corners[v]);
  return out;
}

}  // namespace

TEST_CASE("every format and encoding gives the same surface, recognized by its content") {
  for (const Sample& sample : samples()) {
    for (const std::string& name : {sample.name, std::string("a.msh"), std::string("a")}) {
      INFO(sample.format << " as " << name);
      const MeshFile file = read_mesh_content(name, sample.content);
      CHECK(file.is_surface());
      CHECK(file.format == sample.format);
      CHECK(file.mesh.positions.size() == 4);
      CHECK(places(file) == expected_places());
      CHECK(file.faces.ends == std::vector<std::size_t>{3, 6, 9, 12});
      CHECK(file.ignored.triangles == 4);
      CHECK(file.notes.empty());
      if (sample.name == "a.ply") CHECK(file.vertex_colors == std::vector<std::uint32_t>(4, 0xff0080ff));
    }
  }
}

TEST_CASE("a surface cut at any byte is refused, or whole, or noted") {
  for (const Sample& sample : samples()) {
    std::size_t refused = 0;
    for (std::size_t length = 0; length < sample.content.size(); ++length) {
      CAPTURE(sample.format, length);
      try {
        const MeshFile file = read_mesh_content(sample.name, std::string_view(sample.content).substr(0, length));
        if (places(file) == expected_places()) continue;
        REQUIRE(!file.notes.empty());
        CHECK(file.notes.back().find("cut off") != std::string::npos);
      } catch (const Error& error) {
        const std::string text = error.what();
        CHECK(text.starts_with(sample.name));
        CHECK(text.find('\n') == std::string::npos);
        ++refused;
      }
    }
    INFO(sample.format << ": " << refused << " of " << sample.content.size() << " refused");
    CHECK(refused > sample.content.size() / 2);
  }
}

TEST_CASE("STL: bad files") {
  const auto text_error = [](const std::string& from, const std::string& to) {
    return error_of("a.stl", replaced(stl_text(), from, to));
  };
  CHECK(text_error("outer", "inner") == "a.stl:3: found 'inner'; expected outer");
  CHECK(text_error("1.5", "nan") == "a.stl:13: a coordinate of a vertex is nan; expected a finite number");
  CHECK(text_error("0 0 1.5", "0 0") == "a.stl:14: a coordinate of a vertex is 'endloop'; expected a number");
  CHECK(text_error("endloop", "vertex 1 2 3") == "a.stl:7: found 'vertex'; expected endloop");
  CHECK(text_error("solid a tet\n", "solid a tet\nsolid b\n") == "a.stl:2: found 'solid'; expected endsolid");
  CHECK(error_of("a.stl", "solid a\nendsolid a\n") ==
        "a.stl: holds no tets (0 vertices, 0 lines, 0 triangles, 0 other cells); expected at least one");
  std::string binary = stl_binary();
  binary[80] = 5;
  CHECK(error_of("a.stl", binary) ==
        "a.stl: byte 80: claims 5 triangles but only 200 bytes follow; expected a complete file");
  binary[80] = 3;
  CHECK(error_of("a.stl", binary) ==
        "a.stl: byte 234: something follows the last of 3 triangles; expected the end of the file");
  binary = stl_binary();
  binary.replace(84 + 12 + 4, 4, Bytes().add(std::numeric_limits<float>::infinity()).text);
  CHECK(error_of("a.stl", binary) == "a.stl: byte 100: a coordinate of a vertex is infinite; expected a finite number");
}

TEST_CASE("PLY: strips of triangles, several in one list and joined by degenerate ones") {
  const std::string strips =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const MeshFile file = read_mesh_content("a.ply", strips + "12 0 2 1 3 -1 0 1 3 3 3 2 0\n");
  CHECK(file.faces.ends == std::vector<std::size_t>{3, 6, 9, 12});
  CHECK(file.faces.corners == std::vector<std::uint32_t>{0, 2, 1, 1, 2, 3, 0, 1, 3, 3, 2, 0});
}

TEST_CASE("PLY: bad files") {
  const auto text_error = [](const std::string& from, const std::string& to) {
    return error_of("a.ply", replaced(ply_text(), from, to));
  };
  CHECK(text_error("ascii", "text") ==
        "a.ply:2: format is 'text'; expected ascii, binary_little_endian or binary_big_endian");
  CHECK(text_error("element vertex 4", "element vertex 1000000000000") ==
        "a.ply:16: element vertex: claims 1000000000000 elements but only 109 bytes follow; expected a complete file");
  CHECK(text_error("element vertex 4", "element vertex 5") ==
        "a.ply:21: element vertex: the line ends before a property; expected more numbers on it");
  CHECK(text_error("element vertex 4", "element vertex 3") ==
        "a.ply:20: element face: '1.5' follows the properties of an element; expected the end of the line");
  CHECK(text_error("property float x", "property float u") ==
        "a.ply:4: element vertex: element vertex has no property x; expected x, y and z of a vertex");
  CHECK(text_error("double y", "real y") == "a.ply:6: type is 'real'; expected a type such as float, uchar or int");
  CHECK(text_error("7 3 0 2 1", "7 3 0 2 4") == "a.ply:21: element face: face 0 names vertex 4; expected 0 to 3");
  CHECK(text_error("7 3 0 2 1", "7 3 0 2 -1") == "a.ply:21: element face: face 0 names vertex -1; expected 0 to 3");
  CHECK(text_error("7 3 0 2 1", "7 -3 0 2 1") ==
        "a.ply:21: element face: the length of a list is -3; expected 0 or more");
  CHECK(text_error("0 0 1.5", "0 0 inf") ==
        "a.ply:20: element vertex: coordinate z of vertex 3 is infinite; expected a finite number");
  CHECK(text_error("12\n", "12\n13\n") == "a.ply:26: something follows the last element; expected the end of the file");
  CHECK(text_error("end_header", "end_hea") ==
        "a.ply:16: found 'end_hea'; expected format, element, property, comment or end_header");
  CHECK(error_of("a.ply", ply_binary(false) + "x") ==
        "a.ply: byte 443: something follows the last element; expected the end of the file");
}

TEST_CASE("OFF: its freedoms, and bad files") {
  const std::string text = off_text("OFF", "");
  const auto off_error = [&](const std::string& from, const std::string& to) {
    return error_of("a.off", replaced(text, from, to));
  };
  const auto reads = [](const std::string& content) { return read_mesh_content("a.off", content).faces.ends.size(); };
  CHECK(reads(replaced(text, "OFF # surface\n", "OFF")) == 4);  // the first count right behind the keyword
  CHECK(reads(replaced(text, "OFF # surface\n", "")) == 4);     // without a keyword
  CHECK(reads(replaced(text, "4 4 0\n", "4 4\n")) == 4);        // without the edges
  CHECK(reads(replaced(replaced(text, "4 4 0", "4 3 0"), "3 0 2 1 255 0 0\n3 0 1 3", "4 0 2 1 3")) == 3);
  CHECK(off_error("OFF", "4OFF") == "a.off:2: begins with '4OFF'; expected OFF of three dimensions");
  CHECK(off_error("1 0 0\n", "1 0 0 9\n") ==
        "a.off:5: '9' follows the vertex coordinates; expected the end of the line");
  CHECK(off_error("3 0 2 1", "3 0 2 4") == "a.off:8: face 0 names vertex 4; expected 0 to 3");
  CHECK(off_error("3 0 2 1", "9 0 2 1") == "a.off:8: face 0 names vertex 255; expected 0 to 3");
  CHECK(off_error("4 4 0", "4 5 0") ==
        "a.off:12: the file ends before the number of vertices of a face; expected a complete file");
  CHECK(off_error("4 4 0", "4 3 0") == "a.off:11: something follows the last of 3 faces; expected the end of the file");
  CHECK(off_error("4 4 0", "4 4000000000000 0") ==
        "a.off:3: claims 4000000000000 faces but only 93 bytes follow; expected a complete file");
}

TEST_CASE("OFF: binary files of either byte order, with colors and normals") {
  const auto off = [](bool big_endian, const std::string& keyword, std::size_t behind, std::int32_t last) {
    Bytes out(big_endian);
    out.add_text(keyword + " BINARY\n").add_all(std::vector<std::int32_t>{4, 4, 0});
    for (const std::vector<float>& x : {std::vector<float>{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
      out.add_all(x).add_all(std::vector<float>(behind, .5f));
    for (const std::vector<std::int32_t>& face : {std::vector<std::int32_t>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}})
      out.add(std::int32_t{3}).add_all(face).add(std::int32_t{0});
    out.add(std::int32_t{3}).add_all(std::vector<std::int32_t>{1, 2, last});
    return out.add(std::int32_t{1}).add(.5f).text;
  };
  for (const bool big_endian : {true, false}) {
    for (const auto& [keyword, behind] : {std::pair("OFF", 0), std::pair("CNOFF", 7), std::pair("STOFF", 2)}) {
      const std::string content = off(big_endian, keyword, static_cast<std::size_t>(behind), 3);
      const MeshFile file = read_mesh_content("a.off", content);
      CHECK(file.format == "OFF binary");
      CHECK(file.mesh.positions == std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
      CHECK(file.faces.corners == std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
      for (std::size_t length = 11; length < content.size(); ++length)
        CHECK(!error_of("a.off", content.substr(0, length)).empty());
    }
  }
  CHECK(error_of("a.off", off(true, "OFF", 0, 4)) == "a.off: byte 143: face 3 names vertex 4; expected 0 to 3");
  CHECK(error_of("a.off", off(true, "OFF", 0, 3) + "xx") ==
        "a.off: byte 155: something follows the last of 4 faces; expected the end of the file");
}
