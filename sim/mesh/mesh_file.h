// A mesh as stored in a file, and a record of skipped content.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

struct MeshFile {
  TetMesh mesh;
  std::string format;  // as displayed: "Gmsh 4.1 binary"
  struct {
    std::size_t points = 0, lines = 0, triangles = 0,
                others = 0;  // cells that are not tets: counted, not stored
  } ignored;
  std::vector<std::string> notes;  // about other skipped or changed content, one sentence each
};

}  // namespace fascia
