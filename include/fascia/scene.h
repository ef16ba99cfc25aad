// A scene made from arrays. Scenes in files (docs of the scene format) are opened by Simulation::open().
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
  /// Vertices that are led: from rest along a straight line, where they are held afterwards.
  struct Motion {
    std::vector<std::uint32_t> vertices{};  // of the body's mesh; each in one motion at most
    Vec3 translate{0, 0, 0};                // [m]
    double start = 0, duration = 0;         // [s]
  };

  struct Body {
    std::string name = "body";
    Mesh mesh{};
    Material material{};                         // of all regions that the next line does not name
    std::map<int, Material> region_materials{};  // by Mesh::regions
    std::vector<std::uint32_t> fixed{};          // vertices of the mesh that stay where they are at rest
    std::vector<Motion> motions{};
    std::vector<double>
        initial_velocity{};  // [vertex_count][3] [m/s]; empty: none. Without effect at fixed and led vertices
  };

  struct Scene {
    std::string title{};
    std::vector<Body> bodies{};  // at least one. Bodies do not touch each other: there is no contact
    Vec3 gravity{0, -9.81, 0};   // [m/s^2]
    Settings settings{};
  };

}  // namespace api
}  // namespace fascia
