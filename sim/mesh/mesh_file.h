// A mesh as a file had it, and what was passed over when it was read.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

struct MeshFile {
  TetMesh mesh;
  std::string format;  // for people: "Gmsh 4.1 binary"
  struct {
    std::size_t points = 0, lines = 0, triangles = 0,
                others = 0;  // cells that are not tets: counted, not kept
  } ignored;
  std::vector<std::string> notes;  // what else was passed over or changed, one sentence each
};

}  // namespace fascia
