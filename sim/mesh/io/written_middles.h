// The middle vertices of quadratic tets on the way from a file to another one. A body has those of a file by
// keep_mid_edges() (mesh_io.h), which makes edges straight.
#pragma once
#include <filesystem>

#include "sim/mesh/mesh_file.h"

namespace fascia {

/// Gives the mesh of a file its quadratic tets for write_mesh() to `out`, with their middle vertices where they are, in
/// the order of kMidEdgeCorners; none if the format of `out` is written with four vertices per tet. Its notes then
/// speak of what is written.
void keep_written_middles(MeshFile& file, const std::filesystem::path& out);

}  // namespace fascia
