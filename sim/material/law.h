// A hyperelastic law: the energy that a MaterialModel assigns to a deformation. Each law is one file here, one in
// shaders/sim/material and one row of the table in laws.cpp; docs/developers/adding.md adds one step by step.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "sim/material/material.h"

namespace fascia {

using Matrix9d = Eigen::Matrix<double, 9, 9>;

/// Energy density Psi [J/m^3] at a deformation gradient F, and its derivatives by the components of F, in column-major
/// order [Pa].
struct Density {
  double energy = 0;
  Eigen::Matrix3d first = Eigen::Matrix3d::Zero();  // first Piola stress P
  Matrix9d second = Matrix9d::Zero();               // only where requested
};

struct MaterialLaw {
  MaterialModel model;
  const char* name;   // in scene files; its kernel functions are NAME_response, NAME_curvature, NAME_block
  const char* label;  // in the panel
  const char* help;
  const char* own_field;  // the field of Material that only this law reads; null: none
  bool of_strain;  // Psi is a function of the Green strain that kernels get from deformation_of(), as the XPBD methods
                   // require
  /// Whether Psi equals St. Venant-Kirchhoff's, whose formulas keep more digits; null: never.
  bool (*is_st_venant_kirchhoff)(const Eigen::Matrix3d& f);
  Density (*density)(const Eigen::Matrix3d& f, const Material& material, bool with_second);
  bool fades_damping = false;  // viscosity falls with damping_share()
};

extern const MaterialLaw kSignedStVenantKirchhoff, kStVenantKirchhoff, kStableNeoHookean, kNeoHookean, kMooneyRivlin,
    kSquared;

const std::vector<const MaterialLaw*>& material_laws();  // all of them, in the order of the menu
const MaterialLaw& law_of(MaterialModel model);

/// Factor of the damping, at most 1, of a tet with Green strain E_n at the start of a step. D : (E - E_n)/h resists a
/// change of F in proportion to |F|^2: a law whose stiffness does not follow has it divided by |F_n|^2 / 3 = 1 + 2/3 tr
/// E_n where that is above 1, so that drawn-out tets do not creep for seconds.
double damping_share(MaterialModel model, const Eigen::Matrix3d& previous_strain);

bool reads(MaterialModel model, std::string_view field);  // of Material, by its name in visit_material()

}  // namespace fascia
