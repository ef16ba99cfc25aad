// Reading and writing tetrahedral meshes and surfaces. The format is detected from the content, not only from the
// extension; mesh_formats.h lists all of them.
//
// Read:  Gmsh .msh 1.0 ASCII, 2.2 and 4.1 ASCII and binary · VTK legacy unstructured grids and polydata, ASCII and
//        binary, up to the 5.x OFFSETS/CONNECTIVITY layout · .vtu and .vtp ASCII, base64, appended (raw or base64),
//        plain or zlib · TetGen .node/.ele (either file may be named) · Medit .mesh ASCII · Abaqus .inp · FEBio .feb ·
//        Vega .veg · STL and PLY, ASCII and binary · OFF ASCII.
// Write: .msh (Gmsh 4.1 ASCII) · .vtk · .vtu · .node/.ele · .mesh · .inp, by the extension.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "sim/mesh/mesh_file.h"

namespace fascia {

/// Throws Error "path:line: what; what was expected" on anything that is not a readable mesh with at least one tet, or
/// pyramid, wedge or hexahedron, which become tets. Allocations for counts in the file are limited to what the file can
/// fill.
MeshFile read_mesh(const std::filesystem::path& path, const Progress& progress = {});

/// Makes the edges of a file's quadratic tets straight, for a body that keeps all of their nodes, and says so in its
/// notes, as it does of tets without these nodes. The file's vertices in the middles of the edges of `usable` tets.
/// Throws Error, which begins with `where`, if they are no middles of edges, each of its own.
std::vector<std::uint32_t> keep_mid_edges(MeshFile& file, const std::vector<std::uint32_t>& usable,
                                          const std::string& where);

/// Writes through a temporary name and renames. Throws Error for an unknown extension or a failed write.
void write_mesh(const std::filesystem::path& path, const TetMesh& mesh);

/// The names in the mesh that the format of this extension cannot hold, as one sentence; empty if nothing is lost.
std::string names_left_out(const std::filesystem::path& path, const TetMesh& mesh);

}  // namespace fascia
