// A scene's prescribed motion on the vertices of a mesh.
#pragma once
#include <string>
#include <vector>

#include "sim/model.h"

namespace fascia {

/// `vertices` are those of the body's mesh. Throws Error as select_vertices and read_vertex_csv do, and for
/// selected vertices that the CSV file of targets misses.
Motion resolve_motion(const PrescribedMotion& motion, const Scene& scene, const TetMesh& mesh,
                      const std::vector<char>& used, const std::string& where);

}  // namespace fascia
