// Medit .mesh in text: sections by keyword, vertices numbered from 1, a reference number after each item.
#include <cctype>
#include <map>

#include "base/number_text.h"
#include "sim/mesh/io/cell_split.h"
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
      } else if (const auto kind = kKinds.find(keyword); kind != kKinds.end()) {
        read_cells(kind->second);
      } else {
        skip_section();
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

  struct Kind {
    const char* name;
    int dimension;
    std::size_t corners, nodes;
  };
  static inline const std::map<std::string_view, Kind> kKinds = {{"Edges", {"edge", 1, 2, 2}},
                                                                 {"EdgesP2", {"edge", 1, 2, 3}},
                                                                 {"Triangles", {"triangle", 2, 3, 3}},
                                                                 {"TrianglesP2", {"triangle", 2, 3, 6}},
                                                                 {"Quadrilaterals", {"quad", 2, 4, 4}},
                                                                 {"QuadrilateralsQ2", {"quad", 2, 4, 9}},
                                                                 {"Tetrahedra", {"tet", 3, 4, 4}},
                                                                 {"TetrahedraP2", {"tet", 3, 4, 10}},
                                                                 {"Hexahedra", {"hexahedron", 3, 8, 8}},
                                                                 {"Hexaedra", {"hexahedron", 3, 8, 8}},
                                                                 {"HexahedraQ2", {"hexahedron", 3, 8, 27}},
                                                                 {"Prisms", {"prism", 3, 6, 6}},
                                                                 {"PrismsP2", {"prism", 3, 6, 18}},
                                                                 {"Pyramids", {"pyramid", 3, 5, 5}},
                                                                 {"PyramidsP2", {"pyramid", 3, 5, 14}}};

  void read_cells(const Kind& kind) {
    const std::size_t count = in_.count("cells", 2 * (kind.nodes + 1));
    const auto vertex_count = static_cast<std::int64_t>(file_.mesh.positions.size());
    std::vector<std::uint32_t> corners(kind.corners), others(kind.nodes - kind.corners);
    for (std::size_t c = 0; c < count; ++c) {
      for (std::size_t i = 0; i < kind.nodes; ++i) {
        const auto vertex = in_.number<std::int64_t>("a vertex of a cell");
        if (vertex < 1 || vertex > vertex_count) {
          in_.fail(std::string(kind.name) + " " + std::to_string(c + 1) + " names vertex " + std::to_string(vertex),
                   "expected 1 to " + std::to_string(vertex_count));
        }
        (i < kind.corners ? corners[i] : others[i - kind.corners]) = static_cast<std::uint32_t>(vertex - 1);
      }
      const int region = in_.number<int>("the reference of a cell");
      if (kind.dimension == 3) {
        add_solid(file_, corners);
        if (kind.corners == 4 && kind.nodes == 10)
          set_mid_edges(file_, {others[0], others[1], others[2], others[3], others[4], others[5]});
        file_.mesh.regions.resize(file_.mesh.tets.size(), region);
      } else if (kind.dimension == 2) {
        add_face(file_, corners);
      } else {
        count_ignored(file_, kind.dimension, static_cast<int>(kind.corners));
      }
    }
    if (kind.nodes > kind.corners && kind.dimension == 3 && count > 0) file_.notes.push_back(kHigherOrderNote);
  }

  /// Skips numbers up to the next keyword.
  void skip_section() {
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
