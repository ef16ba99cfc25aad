// Reading and writing tetrahedral meshes. The format is detected from the content, not only from the extension.
//
// Read:  Gmsh .msh 1.0 ASCII, 2.2 and 4.1 ASCII and binary · VTK legacy unstructured grid ASCII and binary,
// up to the
//        5.x OFFSETS/CONNECTIVITY layout · .vtu ASCII, base64, appended (raw or base64), plain or zlib ·
//        TetGen .node/.ele (either file may be named) · Medit .mesh ASCII.
// Write: .msh (Gmsh 4.1 ASCII) · .vtk · .vtu · .node/.ele · .mesh, by the extension.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "sim/mesh/mesh_file.h"

namespace fascia {

/// Throws Error "path:line: what; what was expected" on anything that is not a readable mesh with at least one tet.
/// Allocations for counts in the file are limited to what the file can fill.
MeshFile read_mesh(const std::filesystem::path& path, const Progress& progress = {});

inline const std::vector<std::string> mesh_endings{".msh",  ".vtk", ".vtu",
                                                   ".node", ".ele", ".mesh"};  // the extensions of write_mesh()
/// Writes through a temporary name and renames. Throws Error for an unknown extension or a failed write.
void write_mesh(const std::filesystem::path& path, const TetMesh& mesh);

/// The names in the mesh that the format of this extension cannot hold, as one sentence; empty if nothing is lost.
std::string names_left_out(const std::filesystem::path& path, const TetMesh& mesh);

}  // namespace fascia
