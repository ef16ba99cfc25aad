// A scene's prescribed motion on the vertices of a mesh.
#pragma once
#include <string>
#include <vector>

#include "sim/model/file_reader.h"
#include "sim/model/model.h"

namespace fascia {

/// `vertices` are those of the body's mesh; `key` is the motion's in the scene, "bodies[0].prescribed[0]". Throws Error
/// as select_vertices and read_vertex_csv do, and for selected vertices that the CSV file of targets misses.
Motion resolve_motion(const PrescribedMotion& motion, FileReader& files, const TetMesh& mesh,
                      const std::vector<char>& used, const std::string& where, const std::string& key);

}  // namespace fascia
