// Scenes from arrays: bodies with meshes, materials, supports and motions. Simulation::open() opens scenes in files.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fascia/export.h"
#include "fascia/material.h"
#include "fascia/mesh.h"
#include "fascia/settings.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// Vertices that follow a straight line from their rest positions and are held at its end.
  struct Motion {
    /// The indices of the vertices in the body's mesh, at least one. A vertex belongs to one motion at most.
    std::vector<std::uint32_t> vertices{};
    /// The displacement at the end of the motion [m].
    Vec3 translate{0, 0, 0};
    /// The time at which the motion starts [s], at least 0.
    double start = 0;
    /// The length of the motion in time [s], at least 0.
    double duration = 0;
  };

  /// A body: a mesh with materials, supports and motions.
  struct Body {
    /// The name of the body in messages and material names.
    std::string name = "body";
    /// The mesh of the body.
    Mesh mesh{};
    /// The material of all regions that region_materials does not list.
    Material material{};
    /// The materials of single regions, by the numbers of Mesh::regions.
    std::map<int, Material> region_materials{};
    /// The indices of vertices that stay at their rest positions.
    std::vector<std::uint32_t> fixed{};
    /// The motions of the body's vertices.
    std::vector<Motion> motions{};
    /// [vertex_count][3] The velocities at the start [m/s]. If it is empty, the body starts at rest. The values at
    /// fixed and moved vertices are ignored.
    std::vector<double> initial_velocity{};
    /// The elements, as in scene files: "linear" or "quadratic". Quadratic ones have a vertex in the middle of every
    /// edge, too, behind those of the mesh; one whose edge has two fixed or moved ends is fixed or moved with them.
    std::string elements = "linear";
  };

  /// A scene. Simulation::Simulation() checks it and throws Error for values out of range.
  struct Scene {
    /// The title of the scene.
    std::string title{};
    /// The bodies, at least one. There is no contact between bodies.
    std::vector<Body> bodies{};
    /// The acceleration of gravity [m/s^2].
    Vec3 gravity{0, -9.81, 0};
    /// The settings of the solver.
    Settings settings{};
  };

}  // namespace api
}  // namespace fascia
