#include "sim/mesh/io/mesh_io.h"

#include <algorithm>
#include <cctype>
#include <new>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "sim/mesh/io/foreign_formats.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/mesh_formats.h"
#include "sim/mesh/io/xml.h"
#include "sim/mesh/mid_edges.h"
#include "sim/mesh/mid_order.h"

namespace fascia {
namespace fs = std::filesystem;

namespace {

/// As lower_ending, but ".nii.gz" of "head.nii.gz".
std::string full_ending(const fs::path& path) {
  const std::string last = lower_ending(path);
  return last == ".gz" ? lower_ending(path.stem()) + last : last;
}

std::string known_formats() { return "expected one of " + listed_formats(); }

[[noreturn]] void refuse(const fs::path& path, std::string_view content) {
  if (const auto foreign = foreign_format(content, full_ending(path)))
    throw Error(path.string(), std::string("is ") + foreign->name + ", which fascia does not read", foreign->way);
  throw Error(path.string(), "is not a mesh format that fascia reads (begins with " + in_quotes(content) + ")",
              known_formats());
}

/// A section; in Nastran and LS-DYNA files a blank follows the '$' of a comment.
bool is_gmsh(std::string_view word) {
  return word.size() > 1 && word[0] == '$' && std::isalpha(static_cast<unsigned char>(word[1])) != 0;
}

bool is_off(std::string_view word, const std::string& ending) {
  const std::size_t at = word.find("OFF");
  const bool is_keyword = at != word.npos && word.find_first_not_of("STCN4n") >= at &&
                          word.find_first_not_of("0123456789", at + 3) == word.npos;
  return is_keyword || ending == ".off";
}

}  // namespace

MeshFile read_mesh_content(const fs::path& path, std::string_view content, const ReadBeside& read_beside) {
  MeshFile file;
  if (content.empty()) throw Error(path.string(), "is empty", known_formats());
  Scanner in(path.string(), content);
  const std::string_view text = content.substr(in.offset());

  const ReadBeside read_other =
      read_beside ? read_beside : [&](const std::string& name) { return read_file(path.parent_path() / name); };
  Scanner peek = in;
  peek.skip_comments();
  const std::string_view word = in.peek_word();
  const std::string ending = lower_ending(path);
  if (text.starts_with("# vtk DataFile")) {
    read_vtk_legacy(in, file);
  } else if (is_gmsh(word) || is_gmsh(peek.peek_word())) {
    read_gmsh(in, file);
  } else if (word.starts_with("<")) {
    const std::string_view root = xml_root_name(text);
    if (root == "febio_spec")
      read_febio(in, file);
    else if (root != "VTKFile" && foreign_format(text, ending))
      refuse(path, text);
    else
      read_vtu(in, file);
  } else if (word == "*KEYWORD") {
    refuse(path, text);
  } else if (peek.peek_word() == "*VERTICES" || ending == ".veg") {
    read_vega(in, file, read_other);
  } else if (word.starts_with("*")) {
    read_abaqus(in, file, read_other);
  } else if (peek.peek_word().starts_with("MeshVersionFormatted")) {
    read_medit(in, file);
  } else if (word == "ply") {
    read_ply(in, file);
  } else if (is_stl_binary(content)) {
    read_stl_binary(in, file);
  } else if ((word == "solid" || word == "SOLID") && content.find('\0') == content.npos) {
    read_stl_text(in, file);
  } else if (ending == ".stl" || word == "solid") {
    read_stl_binary(in, file);
  } else if (is_off(peek.peek_word(), ending)) {
    read_off(in, file);
  } else if (ending == ".node" || ending == ".ele") {
    read_tetgen(path, content, file, read_beside);
  } else {
    refuse(path, text);
  }
  return file;
}

MeshFile read_mesh(const fs::path& path, const Progress& progress) {
  try {
    MeshFile file = read_mesh_content(path, read_file(path, progress));
    require_tets(file, path.string());
    return file;
  } catch (const std::bad_alloc&) {
    throw Error(path.string(), "needs more memory than there is", "expected a smaller mesh");
  }
}

void write_mesh(const fs::path& path, const TetMesh& mesh) {
  const std::string ending = lower_ending(path);
  if (ending == ".msh") {
    write_file(path, gmsh41_text(path.string(), mesh));
  } else if (ending == ".vtk") {
    write_file(path, vtk_legacy_text(mesh));
  } else if (ending == ".vtu") {
    write_file(path, vtu_text(mesh));
  } else if (ending == ".mesh") {
    write_file(path, medit_text(mesh));
  } else if (ending == ".inp") {
    write_file(path, abaqus_text(mesh));
  } else if (ending == ".node" || ending == ".ele") {
    fs::path other = path;
    write_file(other.replace_extension(".node"), tetgen_node_text(mesh));
    write_file(other.replace_extension(".ele"), tetgen_ele_text(mesh));
  } else {
    throw Error(path.string(), "cannot be written: its ending names no mesh format",
                "expected .msh, .vtk, .vtu, .node, .ele, .mesh or .inp");
  }
}

std::string names_left_out(const fs::path& path, const TetMesh& mesh) {
  const std::string ending = lower_ending(path);
  if (ending != ".mesh" && ending != ".node" && ending != ".ele") return "";
  std::vector<std::string> names;
  for (const auto& [region, name] : mesh.region_names) names.push_back("region " + std::to_string(region) + " " + name);
  for (const auto& [name, vertices] : groups_beyond_regions(mesh)) names.push_back("group " + name);
  if (names.empty()) return "";
  constexpr std::size_t kNamed = 8;
  std::string text = ending + " holds the numbers of regions, no names and no groups. Left out: ";
  for (std::size_t i = 0; i < std::min(names.size(), kNamed); ++i) text += (i ? ", " : "") + names[i];
  return text + (names.size() > kNamed ? " and " + std::to_string(names.size() - kNamed) + " more." : ".");
}

std::vector<std::uint32_t> keep_mid_edges(MeshFile& file, const std::vector<std::uint32_t>& usable,
                                          const std::string& where) {
  if (file.mid_edges.empty()) return {};
  std::erase(file.notes, kHigherOrderNote);
  if (const std::size_t tets = order_mid_edges(file.mesh, usable, file.mid_edges, where); tets > 0)
    file.notes.push_back("middle vertices of " + plural(tets, "quadratic tet") +
                         " are not in the order of the format: put in order by their places");
  require_own_middles(file.mesh, usable, file.mid_edges, where);
  TetMesh whole = file.mesh;
  add_mid_edges(whole, usable, file.mid_edges);
  const auto linear = static_cast<std::size_t>(std::count_if(usable.begin(), usable.end(), [&](std::uint32_t t) {
    return t >= file.mid_edges.size() || file.mid_edges[t] == kNoMidEdges;
  }));
  if (linear > 0)
    file.notes.push_back(plural(linear, "tet") + " of 4 nodes among " + plural(usable.size(), "tet") + ": " +
                         plural(whole.positions.size() - file.mesh.positions.size(), "vertex") +
                         " added in the middles of edges");
  if (const std::size_t curved = straighten(whole); curved > 0)
    file.notes.push_back(plural(curved, "curved edge") + " straightened");
  std::vector<std::uint32_t> kept;
  for (const MidEdge& edge : mid_edges_of(whole))
    if (edge.vertex < file.mesh.positions.size()) kept.push_back(edge.vertex);
  std::copy_n(whole.positions.begin(), file.mesh.positions.size(), file.mesh.positions.begin());
  return kept;
}

}  // namespace fascia
