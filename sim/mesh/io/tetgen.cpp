// TetGen: vertices in NAME.node, tets in NAME.ele, numbered from 0 or 1 as the first vertex is.
#include <array>

#include "base/error.h"
#include "base/file.h"
#include "base/number_text.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/tag_map.h"

namespace fascia {
namespace fs = std::filesystem;

namespace {

TagMap read_node(Scanner& in, MeshFile& file) {
  const std::size_t begin = in.offset();
  const std::size_t count = in.count("vertices", 8);
  check_vertex_count(in, count);
  const int dimension = in.number_on_line<int>("the dimension");
  if (dimension != 3) in.fail("dimension is " + std::to_string(dimension), "expected 3");
  const auto attributes = in.at_line_end() ? 0 : in.number_on_line<unsigned>("the number of attributes");
  const auto markers = in.at_line_end() ? 0 : in.number_on_line<unsigned>("the number of boundary markers");
  in.end_line("the header");
  std::vector<std::int64_t> tags(count);
  file.mesh.positions.reserve(count);
  for (std::int64_t& tag : tags) {
    tag = in.number<std::int64_t>("a vertex number");
    Eigen::Vector3d x;
    for (int k = 0; k < 3; ++k) x[k] = in.coordinate_on_line("a vertex coordinate");
    file.mesh.positions.push_back(x);
    for (unsigned i = 0; i < attributes; ++i) in.number_on_line<double>("an attribute of a vertex");
    for (unsigned i = 0; i < markers; ++i) in.number_on_line<std::int64_t>("a boundary marker");
    in.end_line("the vertex");
  }
  if (!in.at_end())
    in.fail("something follows the last of " + std::to_string(count) + " vertices", "expected the end of the file");
  TagMap vertex_of_tag;
  if (const auto twice = vertex_of_tag.assign(tags)) {
    in.blame(begin);
    in.fail("vertex number " + std::to_string(tags[*twice]) + " occurs twice", "expected every number once");
  }
  return vertex_of_tag;
}

void read_ele(Scanner& in, const TagMap& vertex_of_tag, MeshFile& file) {
  const std::size_t count = in.count("tets", 10);
  const auto nodes = in.at_line_end() ? 4 : in.number_on_line<unsigned>("the number of vertices of a tet");
  if (nodes != 4 && nodes != 10) in.fail("a tet has " + std::to_string(nodes) + " vertices", "expected 4 or 10");
  const auto attributes = in.at_line_end() ? 0 : in.number_on_line<unsigned>("the number of attributes");
  in.end_line("the header");
  TetMesh& mesh = file.mesh;
  mesh.tets.reserve(count);
  bool whole = true;
  for (std::size_t t = 0; t < count; ++t) {
    const auto number = in.number<std::int64_t>("a tet number");
    Tet tet{};
    MidEdges mid_edges = kNoMidEdges;
    for (unsigned i = 0; i < nodes; ++i) {
      const auto tag = in.number_on_line<std::int64_t>("a vertex of a tet");
      const auto vertex = vertex_of_tag.find(tag);
      if (!vertex)
        in.fail("tet " + std::to_string(number) + " names vertex " + std::to_string(tag),
                "expected a vertex of the .node file");
      // The middles of the edges 23, 03, 01, 12, 13, 02.
      constexpr std::array<std::size_t, 6> kPlaces = {5, 3, 0, 1, 4, 2};
      (i < 4 ? tet[i] : mid_edges[kPlaces[i - 4]]) = *vertex;
    }
    int region = 0;
    for (unsigned i = 0; i < attributes; ++i) {
      const double attribute = in.number_on_line<double>("an attribute of a tet");
      if (i > 0) continue;
      const bool fits = is_region(attribute);
      whole &= fits;
      region = fits ? static_cast<int>(attribute) : 0;
    }
    in.end_line("the tet");
    mesh.tets.push_back(tet);
    if (nodes == 10) file.mid_edges.push_back(mid_edges);
    mesh.regions.push_back(region);
  }
  if (!in.at_end())
    in.fail("something follows the last of " + std::to_string(count) + " tets", "expected the end of the file");
  if (!whole) {
    mesh.regions.assign(count, 0);
    file.notes.push_back("The first attribute of the tets is not a whole number: no regions.");
  }
  if (nodes > 4) file.notes.push_back(kHigherOrderNote);
}

/// The file beside `path` with the other extension, in the same case.
fs::path partner(const fs::path& path, const char* lower, const char* upper) {
  fs::path other = path;
  const std::string ending = path.extension().string();
  return other.replace_extension(ending.size() > 1 && ending[1] >= 'a' ? lower : upper);
}

std::string read_partner(const fs::path& path, const fs::path& named) {
  if (!fs::exists(path)) {
    throw Error(path.string(), "no such file", "expected beside " + named.filename().string());
  }
  return read_file(path);
}

template <class Read>
void read_text(const fs::path& where, std::string_view text, MeshFile& file, Read read) {
  Scanner in(where.string(), text);
  in.skip_comments();
  if (in.at_end()) in.fail("holds no numbers", "expected a TetGen file");
  read(in);
  note_cut_off(in, file);
}

}  // namespace

void read_tetgen_content(const fs::path& node_path, std::string_view node, const fs::path& ele_path,
                         std::string_view ele, MeshFile& file) {
  file.format = "TetGen .node/.ele";
  TagMap vertex_of_tag;
  read_text(node_path, node, file, [&](Scanner& in) { vertex_of_tag = read_node(in, file); });
  read_text(ele_path, ele, file, [&](Scanner& in) { read_ele(in, vertex_of_tag, file); });
  finish_mesh(file, ele_path.string());
}

void read_tetgen(const fs::path& path, std::string_view content, MeshFile& file, const ReadBeside& read_beside) {
  const bool is_node = lower_ending(path) == ".node";
  const fs::path node = is_node ? path : partner(path, ".node", ".NODE");
  const fs::path ele = is_node ? partner(path, ".ele", ".ELE") : path;
  const fs::path& partner_path = is_node ? ele : node;
  const std::string other =
      read_beside ? read_beside(partner_path.filename().string()) : read_partner(partner_path, path);
  read_tetgen_content(node, is_node ? content : other, ele, is_node ? other : content, file);
}

std::string tetgen_node_text(const TetMesh& mesh) {
  NumberText out;
  out.add(mesh.positions.size()).add(" 3 0 0\n");
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Eigen::Vector3d& x = mesh.positions[v];
    out.add(v).add(' ').add(x[0]).add(' ').add(x[1]).add(' ').add(x[2]).add('\n');
  }
  return out.take();
}

std::string tetgen_ele_text(const TetMesh& mesh) {
  NumberText out;
  out.add(mesh.tets.size()).add(" 4 1\n");
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    out.add(t);
    for (const std::uint32_t v : mesh.tets[t]) out.add(' ').add(v);
    out.add(' ').add(region_of(mesh, t)).add('\n');
  }
  return out.take();
}

}  // namespace fascia
