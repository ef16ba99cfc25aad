// Reading and writing tetrahedral meshes. The format is found in the content, not only in the file's ending.
//
// Read:  Gmsh .msh 1.0 ASCII, 2.2 and 4.1 ASCII and binary · VTK legacy unstructured grid ASCII and binary,
// up to the
//        5.x OFFSETS/CONNECTIVITY layout · .vtu ASCII, base64, appended (raw or base64), plain or zlib ·
//        TetGen .node/.ele (either file may be named) · Medit .mesh ASCII.
// Write: .msh (Gmsh 4.1 ASCII) · .vtk · .vtu · .node/.ele · .mesh, by the ending.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "sim/mesh/mesh_file.h"

namespace fascia {

/// Throws Error "path:line: what; what was expected" on anything that is not a readable mesh with at least
/// one tet. Counts in the file are never trusted for an allocation larger than the file could fill.
MeshFile read_mesh(const std::filesystem::path& path, const Progress& progress = {});

inline const std::vector<std::string> mesh_endings{".msh",  ".vtk", ".vtu",
                                                   ".node", ".ele", ".mesh"};  // that write_mesh() knows
/// Writes through a temporary name and renames. Throws Error for an unknown ending or a failed write.
void write_mesh(const std::filesystem::path& path, const TetMesh& mesh);

/// What of the mesh's names the format of this ending cannot hold, one sentence; empty if nothing is lost.
std::string names_left_out(const std::filesystem::path& path, const TetMesh& mesh);

}  // namespace fascia
