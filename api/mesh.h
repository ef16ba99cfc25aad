// Converts meshes of the public interface to the library's own, and back.
#pragma once
#include <string>

#include "fascia/mesh.h"
#include "sim/mesh/tet_mesh.h"

namespace fascia::api {

/// Throws Error "where.tets: ..." for arrays of inconsistent sizes, positions that are not finite, or indices out of
/// range.
TetMesh checked(const Mesh& mesh, const std::string& where);

}  // namespace fascia::api
