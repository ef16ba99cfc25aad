// Medit .mesh in text: sections by keyword, vertices numbered from 1, a reference number after each item.
#include <array>
#include <cctype>
#include <map>

#include "base/number_text.h"
#include "sim/mesh/io/formats.h"

namespace fascia {
namespace {

bool is_keyword(std::string_view word) {
  return !word.empty() && std::isalpha(static_cast<unsigned char>(word[0])) != 0;
}

class MeditReader {
 public:
  MeditReader(Scanner& in, MeshFile& file) : in_(in), file_(file) {}

  void read() {
    in_.skip_comments();
    file_.format = "Medit ASCII";
    bool ended = false, has_vertices = false;
    while (!ended && !in_.at_end()) {
      in_.set_section("");
      const std::string keyword(in_.word("a keyword"));
      if (!is_keyword(keyword)) in_.fail("found " + in_quotes(keyword), "expected a keyword");
      in_.set_section(keyword);
      if (keyword == "End") {
        ended = true;
      } else if (keyword == "MeshVersionFormatted") {
        in_.number<int>("the version");
      } else if (keyword == "Dimension") {
        const int dimension = in_.number<int>("the dimension");
        if (dimension != 3) in_.fail("is " + std::to_string(dimension), "expected 3");
      } else if (keyword == "Vertices") {
        if (has_vertices) in_.fail("is the second list of vertices", "expected one");
        has_vertices = true;
        read_vertices();
      } else if (keyword == "Tetrahedra") {
        read_tets(4);
      } else if (keyword == "TetrahedraP2") {
        read_tets(10);
      } else {
        skip_section(keyword);
      }
    }
    in_.set_section("");
    if (!has_vertices) in_.fail("has no vertices", "expected Vertices");
    if (!ended) file_.notes.push_back("The file does not close with 'End'; the file may be cut off.");
    finish_mesh(file_, in_.where());
  }

 private:
  void read_vertices() {
    const std::size_t count = in_.count("vertices", 8);
    check_vertex_count(in_, count);
    file_.mesh.positions.reserve(count);
    for (std::size_t v = 0; v < count; ++v) {
      Eigen::Vector3d x;
      for (int k = 0; k < 3; ++k) x[k] = in_.coordinate("a vertex coordinate");
      in_.number<std::int64_t>("the reference of a vertex");
      file_.mesh.positions.push_back(x);
    }
  }

  void read_tets(int nodes) {
    const std::size_t count = in_.count("tets", 10);
    const auto vertex_count = static_cast<std::int64_t>(file_.mesh.positions.size());
    for (std::size_t t = 0; t < count; ++t) {
      Tet tet{};
      for (int i = 0; i < nodes; ++i) {
        const auto vertex = in_.number<std::int64_t>("a vertex of a tet");
        if (vertex < 1 || vertex > vertex_count) {
          in_.fail("tet " + std::to_string(t + 1) + " names vertex " + std::to_string(vertex),
                   "expected 1 to " + std::to_string(vertex_count));
        }
        if (i < 4) tet[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(vertex - 1);
      }
      file_.mesh.tets.push_back(tet);
      file_.mesh.regions.push_back(in_.number<int>("the reference of a tet"));
    }
    if (nodes > 4 && count > 0) file_.notes.push_back("Tets of higher order: kept the four corners of each.");
  }

  /// Skips numbers up to the next keyword; cells of other kinds are counted.
  void skip_section(const std::string& keyword) {
    struct Kind {
      int dimension, corners;
    };
    static const std::map<std::string_view, Kind> kinds = {
        {"Edges", {1, 2}},       {"EdgesP2", {1, 2}},        {"Triangles", {2, 3}},
        {"TrianglesP2", {2, 3}}, {"Quadrilaterals", {2, 4}}, {"Hexahedra", {3, 8}},
        {"Hexaedra", {3, 8}},    {"Prisms", {3, 6}},         {"Pyramids", {3, 5}}};
    if (const auto kind = kinds.find(keyword); kind != kinds.end()) {
      count_ignored(file_, kind->second.dimension, kind->second.corners, in_.count("cells", 6));
    }
    for (std::string_view word = in_.peek_word(); !word.empty() && !is_keyword(word); word = in_.peek_word()) {
      in_.number<double>("a value");
    }
  }

  Scanner& in_;
  MeshFile& file_;
};

}  // namespace

void read_medit(Scanner& in, MeshFile& file) { MeditReader(in, file).read(); }

std::string medit_text(const TetMesh& mesh) {
  NumberText out;
  out.add("MeshVersionFormatted 2\nDimension 3\nVertices\n").add(mesh.positions.size()).add('\n');
  for (const Eigen::Vector3d& x : mesh.positions) out.add(x[0]).add(' ').add(x[1]).add(' ').add(x[2]).add(" 0\n");
  out.add("Tetrahedra\n").add(mesh.tets.size()).add('\n');
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (const std::uint32_t v : mesh.tets[t]) out.add(v + std::size_t{1}).add(' ');
    out.add(region_of(mesh, t)).add('\n');
  }
  return out.add("End\n").take();
}

}  // namespace fascia
