// OFF (Geomview's object file format) in text: counts, vertices and faces, one each line, '#' before comments. The
// letters before OFF announce normals, colors and texture coordinates behind the position of a vertex, which are
// skipped as are the colors of faces.
#include "sim/mesh/io/cell_split.h"
#include "sim/mesh/io/formats.h"

namespace fascia {
namespace {

/// Whether vertices have more than a position.
bool read_keyword(Scanner& in) {
  const std::string_view word = in.peek_word();
  const std::size_t at = word.find("OFF");
  if (at == std::string_view::npos) return false;  // the keyword is optional
  const std::string_view letters = word.substr(0, at);
  if (letters.find_first_not_of("STCN") != std::string_view::npos)
    in.fail("begins with " + in_quotes(word), "expected OFF of three dimensions");
  in.seek(in.offset() + at + 3);  // some files have the first count right behind it
  if (in.peek_word() == "BINARY") in.fail("is binary OFF", "expected OFF in text");
  return !letters.empty();
}

}  // namespace

void read_off(Scanner& in, MeshFile& file) {
  file.format = "OFF";
  in.skip_comments();
  const bool more = read_keyword(in);
  const std::size_t vertex_count = in.count("vertices", 6);
  const std::size_t face_count = in.count("faces", 4);
  in.line();  // with the number of edges, which programs leave 0
  check_vertex_count(in, vertex_count);
  file.mesh.positions.reserve(vertex_count);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    Eigen::Vector3d x;
    x[0] = in.coordinate("a vertex coordinate");
    for (int k = 1; k < 3; ++k) x[k] = in.coordinate_on_line("a vertex coordinate");
    file.mesh.positions.push_back(x);
    if (more)
      in.line();
    else
      in.end_line("the vertex coordinates");
  }
  std::vector<std::uint32_t> corners;
  for (std::size_t f = 0; f < face_count; ++f) {
    const auto size = in.number<std::uint64_t>("the number of vertices of a face");
    in.check_count(size, "vertices of a face", 2);
    corners.clear();
    for (std::uint64_t i = 0; i < size; ++i) {
      const auto vertex = in.number_on_line<std::int64_t>("a vertex of a face");
      if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertex_count) {
        in.fail("face " + std::to_string(f) + " names vertex " + std::to_string(vertex),
                "expected 0 to " + std::to_string(static_cast<std::int64_t>(vertex_count) - 1));
      }
      corners.push_back(static_cast<std::uint32_t>(vertex));
    }
    add_face(file, corners);
    in.line();
  }
  if (!in.at_end())
    in.fail("something follows the last of " + std::to_string(face_count) + " faces", "expected the end of the file");
  note_cut_off(in, file);
  finish_mesh(file, in.where());
}

}  // namespace fascia
