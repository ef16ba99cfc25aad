// A cube whose surface is displaced, and what CalculiX 2.20 computes for it with C3D10, *STATIC with NLGEOM and
// *ELASTIC, which is St. Venant-Kirchhoff's law. tests/sim/output/test_abaqus_model.cpp writes the input file and,
// where ccx is installed, compares its output with these numbers.
#pragma once
#include <array>
#include <cmath>

#include "tests/sim/reference/box_model.h"

namespace fascia::test {

/// Displacement of the surface of a cube of 1 m [m]: strains of up to 0.2, and no change of volume to first order.
inline Eigen::Vector3d on_cube_surface(const Eigen::Vector3d& x) {
  constexpr double kPi = 3.14159265358979323846;
  return 0.08 * Eigen::Vector3d(std::sin(kPi * x.y()), std::sin(kPi * x.z()), std::sin(kPi * x.x()));
}

/// E = 1 MPa. The whole surface is moved at once.
inline Model displaced_cube(int cells, double nu) {
  const Eigen::Vector3d size(1, 1, 1);
  Material material = soft(1e6, nu);
  material.model = MaterialModel::st_venant_kirchhoff;
  Model model = quadratic(box_model(cells, cells, cells, size, material));
  model.material_names = {"cube"};
  Motion motion;
  motion.vertices = vertices_where(model, on_surface(size));
  for (const std::uint32_t v : motion.vertices)
    motion.targets.push_back(model.rest_positions[v] + on_cube_surface(model.rest_positions[v]));
  model.motions = {motion};
  return model;
}

/// Rest positions [m] of the stored displacements, vertices of every mesh whose number of cells is a multiple of four.
inline const std::array<Eigen::Vector3d, 5> kCalculixPlaces = {
    {{0.25, 0.25, 0.5}, {0.25, 0.5, 0.75}, {0.25, 0.75, 0.5}, {0.5, 0.5, 0.75}, {0.75, 0.75, 0.25}}};

struct CalculixCube {
  double nu;
  int cells;
  double energy;                                                     // [J]
  std::array<Eigen::Vector3d, kCalculixPlaces.size()> displacement;  // [m]
};

inline const std::array<CalculixCube, 6> kCalculixCubes = {{
    {0.3,
     4,
     16471.32,
     {{{4.196574E-02, 6.129789E-02, 4.318375E-02},
       {6.545837E-02, 4.301595E-02, 4.813074E-02},
       {4.347211E-02, 6.798050E-02, 4.374357E-02},
       {6.112542E-02, 4.011155E-02, 6.384684E-02},
       {4.859486E-02, 4.843324E-02, 4.669669E-02}}}},
    {0.3,
     8,
     16445.3,
     {{{4.175655E-02, 6.124212E-02, 4.328165E-02},
       {6.544288E-02, 4.298691E-02, 4.812262E-02},
       {4.355168E-02, 6.792379E-02, 4.379072E-02},
       {6.113244E-02, 4.005866E-02, 6.388263E-02},
       {4.838600E-02, 4.846802E-02, 4.680216E-02}}}},
    {0.45,
     4,
     18386.93,
     {{{4.708275E-02, 6.691019E-02, 4.930353E-02},
       {7.032018E-02, 4.856030E-02, 5.409814E-02},
       {4.789394E-02, 7.485527E-02, 4.949260E-02},
       {6.803577E-02, 4.696878E-02, 7.119918E-02},
       {5.399327E-02, 5.372234E-02, 4.968196E-02}}}},
    {0.45,
     8,
     18321.41,
     {{{4.706397E-02, 6.692340E-02, 4.961580E-02},
       {7.023822E-02, 4.849906E-02, 5.402763E-02},
       {4.807026E-02, 7.461933E-02, 4.959355E-02},
       {6.786971E-02, 4.671103E-02, 7.105799E-02},
       {5.365479E-02, 5.360372E-02, 4.985050E-02}}}},
    {0.49,
     4,
     32864.45,
     {{{5.000694E-02, 6.967321E-02, 5.256949E-02},
       {7.307137E-02, 5.122321E-02, 5.732415E-02},
       {4.972309E-02, 7.813450E-02, 5.361910E-02},
       {7.264585E-02, 5.085751E-02, 7.527881E-02},
       {5.669868E-02, 5.718959E-02, 5.097445E-02}}}},
    {0.49,
     8,
     32568.73,
     {{{5.045897E-02, 6.995976E-02, 5.316401E-02},
       {7.292972E-02, 5.111130E-02, 5.711939E-02},
       {4.999119E-02, 7.768882E-02, 5.374070E-02},
       {7.224903E-02, 5.035175E-02, 7.490033E-02},
       {5.625655E-02, 5.689049E-02, 5.115231E-02}}}},
}};

}  // namespace fascia::test
