// Several meshes as one: each where it is, under its name.
#pragma once
#include <string>

#include "sim/mesh/mesh_file.h"

namespace fascia {

/// Adds the vertices, cells, groups and notes of `part` to those of `file`. Each group of the part is called
/// "name.group" and each of its regions, which stay apart from earlier ones, "name.region", or "name" if it has none.
/// The group "name" has all vertices. A group whose name ends with `shared` is one of all parts, without that ending.
void merge_mesh(MeshFile& file, const MeshFile& part, const std::string& name, const std::string& shared);

}  // namespace fascia
