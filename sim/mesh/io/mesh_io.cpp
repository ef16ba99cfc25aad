#include "sim/mesh/io/mesh_io.h"

#include <algorithm>
#include <new>

#include "base/error.h"
#include "base/file.h"
#include "sim/mesh/io/formats.h"

namespace fascia {
namespace fs = std::filesystem;

namespace {

constexpr const char* known_formats =
    "expected Gmsh .msh, VTK .vtk or .vtu, TetGen .node/.ele or Medit .mesh with tetrahedra";

/// The probable kind of a file that is not a tet mesh, as a hint for the user.
std::string likely_kind(std::string_view content, const std::string& ending) {
  if (content.starts_with("solid") || ending == ".stl") return "is an STL surface";
  if (content.starts_with("ply")) return "is a PLY surface";
  if (content.starts_with("OFF")) return "is an OFF surface";
  if (content.starts_with(std::string_view("\1\0\0\0", 4)) || content.starts_with(std::string_view("\0\0\0\1", 4))) {
    return "looks like binary Medit .meshb";
  }
  return "";
}

[[noreturn]] void refuse(const fs::path& path, std::string_view content) {
  const std::string kind = likely_kind(content, lower_ending(path));
  if (kind.ends_with("surface")) {
    throw Error(path.string(), kind + " without tets",
                "expected a tetrahedral mesh, or a closed surface as Wavefront .obj, which is filled with tets");
  }
  throw Error(path.string(),
              kind.empty() ? "is no mesh that is known here (begins with " + in_quotes(content) + ")" : kind,
              known_formats);
}

}  // namespace

MeshFile read_mesh_content(const fs::path& path, std::string_view content, const ReadBeside& read_beside) {
  MeshFile file;
  if (content.empty()) throw Error(path.string(), "is empty", known_formats);
  Scanner in(path.string(), content);
  const std::string_view text = content.substr(in.offset());

  Scanner peek = in;
  peek.skip_comments();
  const std::string_view word = in.peek_word();
  if (text.starts_with("# vtk DataFile")) {
    read_vtk_legacy(in, file);
  } else if (word.starts_with("$") || peek.peek_word().starts_with("$")) {
    read_gmsh(in, file);
  } else if (word.starts_with("<")) {
    read_vtu(in, file);
  } else if (peek.peek_word().starts_with("MeshVersionFormatted")) {
    read_medit(in, file);
  } else if (const std::string ending = lower_ending(path); ending == ".node" || ending == ".ele") {
    read_tetgen(path, content, file, read_beside);
  } else {
    refuse(path, text);
  }
  return file;
}

MeshFile read_mesh(const fs::path& path, const Progress& progress) {
  try {
    return read_mesh_content(path, read_file(path, progress));
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
  } else if (ending == ".node" || ending == ".ele") {
    fs::path other = path;
    write_file(other.replace_extension(".node"), tetgen_node_text(mesh));
    write_file(other.replace_extension(".ele"), tetgen_ele_text(mesh));
  } else {
    throw Error(path.string(), "cannot be written: its ending names no mesh format",
                "expected .msh, .vtk, .vtu, .node, .ele or .mesh");
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

}  // namespace fascia
