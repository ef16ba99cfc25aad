// STL: every triangle with corners of its own, in text or in little-endian binary. Corners at exactly one position
// become one vertex. Normals are skipped: the winding is what counts.
#include <algorithm>
#include <bit>
#include <cctype>

#include "sim/mesh/io/cell_split.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/vertex_check.h"

namespace fascia {
namespace {

constexpr std::size_t kHeader = 80, kCount = 4, kTriangle = 50;  // [bytes]

std::uint32_t count_at(std::string_view content) {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < kCount; ++i)
    count |= static_cast<std::uint32_t>(static_cast<unsigned char>(content[kHeader + i])) << (8 * i);
  return count;
}

/// Every three corners are a triangle.
void finish_triangles(std::vector<Eigen::Vector3d> corners, MeshFile& file, const std::string& where) {
  const std::vector<std::uint32_t> first = first_at_place(corners);
  std::vector<std::uint32_t> vertex(corners.size());
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (first[c] == c) {
      vertex[c] = static_cast<std::uint32_t>(file.mesh.positions.size());
      file.mesh.positions.push_back(corners[c]);
    } else {
      vertex[c] = vertex[first[c]];
    }
  }
  for (std::size_t c = 0; c + 2 < vertex.size(); c += 3) add_face(file, std::span(vertex).subspan(c, 3));
  finish_mesh(file, where);
}

class StlText {
 public:
  StlText(Scanner& in, MeshFile& file) : in_(in), file_(file) {}

  void read() {
    file_.format = "STL ASCII";
    bool ended = true;
    while (!in_.at_end()) {
      const bool solid = is_next("solid");
      if (!solid && ended) fail("solid");
      if (solid) {
        if (!ended) fail("endsolid");
        in_.line();  // with the name
        ended = false;
      } else if (is_next("endsolid")) {
        in_.line();
        ended = true;
      } else {
        read_facet();
      }
    }
    if (!ended) file_.notes.push_back("The file does not close with 'endsolid'; the file may be cut off.");
    finish_triangles(std::move(corners_), file_, in_.where());
  }

 private:
  bool is_next(std::string_view keyword) {
    const std::string_view word = in_.peek_word();
    return word.size() == keyword.size() && std::equal(word.begin(), word.end(), keyword.begin(), [](char a, char b) {
             return std::tolower(static_cast<unsigned char>(a)) == b;
           });
  }

  [[noreturn]] void fail(const char* expected) {
    const std::string found = in_.at_end() ? "the file ends" : "found " + in_quotes(in_.peek_word());
    in_.fail(found, std::string("expected ") + expected);
  }

  void take(const char* keyword) {
    if (!is_next(keyword)) fail(keyword);
    in_.word(keyword);
  }

  void read_facet() {
    if (!is_next("facet")) fail("facet or endsolid");
    for (const char* const keyword : {"facet", "normal"}) take(keyword);
    for (int k = 0; k < 3; ++k) in_.word("a normal");
    for (const char* const keyword : {"outer", "loop"}) take(keyword);
    for (int corner = 0; corner < 3; ++corner) {
      take("vertex");
      Eigen::Vector3d x;
      for (int k = 0; k < 3; ++k) x[k] = in_.coordinate("a coordinate of a vertex");
      corners_.push_back(x);
    }
    for (const char* const keyword : {"endloop", "endfacet"}) take(keyword);
  }

  Scanner& in_;
  MeshFile& file_;
  std::vector<Eigen::Vector3d> corners_;
};

}  // namespace

bool is_stl_binary(std::string_view content) {
  return content.size() >= kHeader + kCount &&
         content.size() == kHeader + kCount + kTriangle * std::uint64_t{count_at(content)};
}

void read_stl_binary(Scanner& in, MeshFile& file) {
  file.format = "STL binary";
  in.locate_by_byte();
  in.set_swapped(std::endian::native != std::endian::little);
  in.seek(0);  // the header is any 80 bytes
  in.skip(kHeader, "the end of the header");
  const auto count = in.binary<std::uint32_t>("the number of triangles");
  in.check_count(count, "triangles", kTriangle);
  std::vector<Eigen::Vector3d> corners;
  corners.reserve(3 * std::size_t{count});
  for (std::uint32_t t = 0; t < count; ++t) {
    in.skip(3 * sizeof(float), "a normal");
    for (int corner = 0; corner < 3; ++corner) {
      Eigen::Vector3d x;
      for (int k = 0; k < 3; ++k) x[k] = in.binary_coordinate<float>("a coordinate of a vertex");
      corners.push_back(x);
    }
    in.skip(sizeof(std::uint16_t), "the attribute of a triangle");
  }
  if (in.remaining() > 0) {
    in.blame(in.offset());
    in.fail("something follows the last of " + std::to_string(count) + " triangles", "expected the end of the file");
  }
  finish_triangles(std::move(corners), file, in.where());
}

void read_stl_text(Scanner& in, MeshFile& file) { StlText(in, file).read(); }

}  // namespace fascia
