// Resolves a scene's prescribed motion to the vertices of a mesh.
#pragma once
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "sim/model/file_reader.h"
#include "sim/model/model.h"
#include "sim/model/vertex_selection.h"

namespace fascia {

/// `body`: the mesh of the body; `key` is the scene key of the motion, "bodies[0].prescribed[0]". Throws
/// Error as select_vertices and read_vertex_csv do, and if the CSV file of targets misses selected vertices.
Motion resolve_motion(const PrescribedMotion& motion, FileReader& files, const SelectableMesh& body,
                      const std::string& where, const std::string& key);

/// Displacements of the prescribed vertices at time t; leaves those of the others.
void place_prescribed(const Model& model, double t, std::vector<Eigen::Vector3d>& displacement);

/// Takes the other vertices out of the motion, with their targets.
void leave_out(const std::set<std::uint32_t>& others, Motion& motion);

}  // namespace fascia
