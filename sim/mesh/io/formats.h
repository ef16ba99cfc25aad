// One reader and one writer per mesh format, and their common functions. A reader fills a MeshFile from a whole file in
// memory; a writer returns the text of the file.
#pragma once
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/io/scanner.h"

namespace fascia {

void read_gmsh(Scanner& in, MeshFile& file);
void read_vtk_legacy(Scanner& in, MeshFile& file);
void read_vtu(Scanner& in, MeshFile& file);
void read_medit(Scanner& in, MeshFile& file);
void read_febio(Scanner& in, MeshFile& file);
void read_off(Scanner& in, MeshFile& file);
void read_ply(Scanner& in, MeshFile& file);
void read_stl_binary(Scanner& in, MeshFile& file);
void read_stl_text(Scanner& in, MeshFile& file);
/// Whether the size of a file is that of a binary STL file with its count.
bool is_stl_binary(std::string_view content);
/// Returns the content of a file by its name, in the folder of the file that is read. Throws Error.
using ReadBeside = std::function<std::string(const std::string& name)>;

/// Files that they include are read by `read_beside`.
void read_abaqus(Scanner& in, MeshFile& file, const ReadBeside& read_beside);
void read_vega(Scanner& in, MeshFile& file, const ReadBeside& read_beside);
/// `path` is the .node or the .ele file and `content` its content; the other file is read, from disk if `read_beside`
/// is empty.
void read_tetgen(const std::filesystem::path& path, std::string_view content, MeshFile& file,
                 const ReadBeside& read_beside = {});
/// As read_tetgen of two files with these contents.
void read_tetgen_content(const std::filesystem::path& node_path, std::string_view node,
                         const std::filesystem::path& ele_path, std::string_view ele, MeshFile& file);

/// The content of a file: tets, or a surface (MeshFile::is_surface). `path` is for errors and detection.
MeshFile read_mesh_content(const std::filesystem::path& path, std::string_view content,
                           const ReadBeside& read_beside = {});

/// `where` is the file's name for the Error about data that a format cannot hold.
std::string gmsh41_text(const std::string& where, const TetMesh& mesh);
std::string gmsh22_text(const std::string& where, const TetMesh& mesh);
std::string vtk_legacy_text(const TetMesh& mesh);
std::string vtu_text(const TetMesh& mesh);
std::string medit_text(const TetMesh& mesh);
std::string abaqus_text(const TetMesh& mesh);
std::string tetgen_node_text(const TetMesh& mesh);
std::string tetgen_ele_text(const TetMesh& mesh);

/// Of every reader that finds cells with nodes between their corners.
inline constexpr const char* kHigherOrderNote =
    "Cells of higher order: kept the corners of each; elements=quadratic keeps all nodes of quadratic tets.";

/// Adds a cell that is not a tet to `ignored`, by its dimension and number of corners.
void count_ignored(MeshFile& file, int dimension, int corners, std::size_t cells = 1);

/// Throws Error if a file holds no tets.
void require_tets(const MeshFile& file, const std::string& where);

/// Last step of every reader: refuses a file with neither tets nor faces, keeps faces only without tets, makes regions
/// selectable as groups and puts groups in order.
void finish_mesh(MeshFile& file, const std::string& where);

/// Adds a note if a text file that must end with a number does not end with a line break: it may be truncated.
void note_cut_off(const Scanner& in, MeshFile& file);

/// Throws Error if a mesh has more vertices than a 32-bit index can name.
void check_vertex_count(const Scanner& in, std::size_t vertices);

/// The group name of a region: its own name, or its number in decimal.
std::string region_group_name(const TetMesh& mesh, int region);

/// Ascending vertices of the tets of each region but 0, by region_group_name.
std::map<std::string, std::vector<std::uint32_t>> region_groups(const TetMesh& mesh);

/// The groups that are not restored by reading the regions; pointers into the mesh.
std::vector<std::pair<std::string, const std::vector<std::uint32_t>*>> groups_beyond_regions(const TetMesh& mesh);

/// Whether a number can be a region, for formats that only have floating-point numbers.
inline bool is_region(double value) {
  return value == std::round(value) && value >= std::numeric_limits<int>::min() &&
         value <= std::numeric_limits<int>::max();
}

inline int region_of(const TetMesh& mesh, std::size_t tet) { return mesh.regions.empty() ? 0 : mesh.regions[tet]; }

}  // namespace fascia
