// OFF (Geomview's object file format): counts, vertices and faces, in text one each line, '#' before comments. The
// letters before OFF announce normals, colors and texture coordinates behind the position of a vertex, which are
// skipped as are the colors of faces. Binary files hold 32-bit numbers, the last byte first as Geomview writes them, or
// in the order of the machine, as other programs do.
#include <string>

#include "sim/mesh/io/cell_split.h"
#include "sim/mesh/io/formats.h"

namespace fascia {
namespace {

struct Head {
  std::string letters;  // before OFF
  bool binary = false;
};

Head read_keyword(Scanner& in) {
  const std::string_view word = in.peek_word();
  const std::size_t at = word.find("OFF");
  if (at == std::string_view::npos) return {};  // the keyword is optional
  Head head{std::string(word.substr(0, at)), false};
  if (head.letters.find_first_not_of("STCN") != std::string::npos)
    in.fail("begins with " + in_quotes(word), "expected OFF of three dimensions");
  in.seek(in.offset() + at + 3);  // some files have the first count right behind it
  head.binary = in.peek_word() == "BINARY";
  return head;
}

void require_vertex(const Scanner& in, std::size_t face, std::int64_t vertex, std::size_t vertex_count) {
  if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertex_count) {
    in.fail("face " + std::to_string(face) + " names vertex " + std::to_string(vertex),
            "expected 0 to " + std::to_string(static_cast<std::int64_t>(vertex_count) - 1));
  }
}

/// Numbers behind the position of a vertex, by the letters before OFF.
std::size_t numbers_behind(const std::string& letters) {
  std::size_t numbers = 0;
  for (const char letter : letters) numbers += letter == 'N' ? 3 : letter == 'C' ? 4 : 1;
  return numbers;
}

void require_file_end(Scanner& in, std::size_t face_count) {
  if (!in.at_end())
    in.fail("something follows the last of " + std::to_string(face_count) + " faces", "expected the end of the file");
}

/// The other byte order fits if only with it the counts fit the size of the file.
void find_byte_order(Scanner& in, std::size_t vertex_bytes) {
  const auto fit = [&](bool swapped) {
    Scanner head = in;
    head.set_swapped(swapped);
    const std::uint64_t vertices = head.binary<std::uint32_t>("the number of vertices");
    const std::uint64_t faces = head.binary<std::uint32_t>("the number of faces");
    return vertices * vertex_bytes + faces * 2 * sizeof(std::int32_t) <= head.remaining();
  };
  in.set_swapped(fit(true) || !fit(false));
}

void read_binary_off(Scanner& in, MeshFile& file, const std::string& letters) {
  file.format = "OFF binary";
  in.word("BINARY");
  in.line();
  in.locate_by_byte();
  const std::size_t behind = numbers_behind(letters) * sizeof(float), vertex_bytes = 3 * sizeof(float) + behind;
  find_byte_order(in, vertex_bytes);
  const std::size_t vertex_count = in.binary<std::uint32_t>("the number of vertices");
  in.check_count(vertex_count, "vertices", vertex_bytes);
  const std::size_t face_count = in.binary<std::uint32_t>("the number of faces");
  in.check_count(face_count, "faces", 2 * sizeof(std::int32_t));
  in.binary<std::uint32_t>("the number of edges");
  check_vertex_count(in, vertex_count);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    Eigen::Vector3d x;
    for (int k = 0; k < 3; ++k) x[k] = in.binary_coordinate<float>("a vertex coordinate");
    in.skip(behind, "the normal, color or texture coordinates of a vertex");
    file.mesh.positions.push_back(x);
  }
  std::vector<std::uint32_t> corners;
  for (std::size_t f = 0; f < face_count; ++f) {
    const auto size = in.binary<std::uint32_t>("the number of vertices of a face");
    in.check_count(size, "vertices of a face", sizeof(std::int32_t));
    corners.resize(size);
    for (std::uint32_t& corner : corners) {
      const auto vertex = in.binary<std::int32_t>("a vertex of a face");
      require_vertex(in, f, vertex, vertex_count);
      corner = static_cast<std::uint32_t>(vertex);
    }
    add_face(file, corners);
    const auto colors = in.binary<std::uint32_t>("the number of color components of a face");
    in.check_count(colors, "color components of a face", sizeof(float));
    in.skip(colors * sizeof(float), "the color of a face");
  }
  require_file_end(in, face_count);
  finish_mesh(file, in.where());
}

}  // namespace

void read_off(Scanner& in, MeshFile& file) {
  file.format = "OFF";
  in.skip_comments();
  const auto [letters, binary] = read_keyword(in);
  if (binary) return read_binary_off(in, file, letters);
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
    if (!letters.empty())
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
      require_vertex(in, f, vertex, vertex_count);
      corners.push_back(static_cast<std::uint32_t>(vertex));
    }
    add_face(file, corners);
    in.line();
  }
  require_file_end(in, face_count);
  note_cut_off(in, file);
  finish_mesh(file, in.where());
}

}  // namespace fascia
