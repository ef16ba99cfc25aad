// The surface of a model's tissue: what tools press on, and what touches itself and other tissue.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sim/model/model.h"

namespace fascia {

/// In triangles between vertices, wound outward: four in a face of a quadratic tet.
std::vector<Triangle> tissue_boundary(const Model& model);
double area_of(const Model& model, const Triangle& triangle);  // [m^2] at rest

/// [vertex_count] in Model::bodies; 0 in models without parts.
std::vector<std::uint32_t> bodies_of_vertices(const Model& model);

struct TissueEdge {
  std::uint32_t from, to;                // ascending vertices
  std::array<std::uint32_t, 2> sides{};  // triangles at it, of more than two the first and the last
  double area = 0;                       // [m^2] of all triangles at it
  static constexpr std::uint32_t kNoSide = ~0u;
};
/// In the order in which the triangles name them.
std::vector<TissueEdge> tissue_edges(const Model& model, const std::vector<Triangle>& triangles);

/// [vertex_count] a third of the triangles around each vertex [m^2]; 0 inside.
std::vector<double> tissue_areas(const Model& model, const std::vector<Triangle>& triangles);
/// lambda + 2 mu [Pa], what a cell resists with that cannot give way to the sides, for a Poisson ratio of at most 0.45.
/// Beyond it that grows to the bulk modulus, and what presses the surface hardly feels it: the cells around make room.
double surface_modulus(const Material& material);
/// [vertex_count] surface_modulus() / l [Pa/m] of the tissue below each vertex of the surface, with the height
/// l = 2 V / A of a cell; 0 inside.
std::vector<double> tissue_stiffness(const Model& model, const std::vector<double>& areas);
/// [vertex_count] viscosity over stiffness [s] of the tissue at each vertex.
std::vector<double> tissue_viscosity(const Model& model);

}  // namespace fascia
