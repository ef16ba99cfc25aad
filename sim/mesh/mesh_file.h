// A mesh as stored in a file, and a record of skipped content.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace fascia {

/// Polygons one after another, three or more corners each.
struct MeshFaces {
  std::vector<std::uint32_t> corners;  // vertices of all faces
  std::vector<std::size_t> ends;       // [face_count] end of each face in `corners`
};

struct MeshFile {
  TetMesh mesh;
  std::string format;                        // as displayed: "Gmsh 4.1 binary"
  MeshFaces faces;                           // only of a surface: a file with faces and without tets
  std::vector<std::uint32_t> vertex_colors;  // of a surface: [vertex_count] sRGB 0xAABBGGRR, AA = ff; or empty
  struct {
    std::size_t points = 0, lines = 0, triangles = 0, polygons = 0,
                others = 0;  // cells that are not tets: counted, not stored
  } ignored;
  struct {
    std::size_t hexahedra = 0, wedges = 0, pyramids = 0, tets = 0;  // cells, and the tets they became
  } split;
  std::vector<MidEdges> mid_edges;  // [tet_count] of tets of ten nodes, kNoMidEdges of others; or empty
  std::optional<double> filled;     // volume of tets that fill a surface, over what that encloses
  std::vector<std::string> notes;   // about other skipped or changed content, one sentence each

  bool is_surface() const { return mesh.tets.empty() && !faces.ends.empty(); }
};

/// "4 triangles, 1 line": the cells of the file that are neither tets nor became any; empty if there are none.
std::string ignored_cells(const MeshFile& file);

}  // namespace fascia
