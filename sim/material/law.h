// A hyperelastic law: the energy that a MaterialModel assigns to a deformation. Each law is one file here, one in
// shaders/sim/material and one row of the table in laws.cpp; docs/developers/adding.md adds one step by step.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "sim/material/invariants.h"
#include "sim/material/material.h"

namespace fascia {

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
  /// K and theta of volume_split(); where K would be negative, nothing is averaged.
  double (*averaged_bulk)(const Material& material);
  Dilatation (*dilatation)(const Eigen::Matrix3d& f, bool with_second);
  bool fades_damping = false;  // viscosity falls with damping_share()
};

extern const MaterialLaw kSignedStVenantKirchhoff, kStVenantKirchhoff, kStableNeoHookean, kNeoHookean, kMooneyRivlin,
    kSquared;

const std::vector<const MaterialLaw*>& material_laws();  // all of them, in the order of the menu
const MaterialLaw& law_of(MaterialModel model);

/// The two parts of a law for elements that average their change of volume (sim/elements/quadratic_tet.h). With
/// unchanged mu,
///
///   Psi(F; lambda) = Psi(F; lambda - K) + K/2 theta(F)^2,   K >= 0
///
/// since every law here is linear in lambda apart from the sign of its volume term. Such an element takes the first
/// part, `pointwise`, at each point and K/2 (mean theta)^2 once. Changes of volume whose mean is zero meet the first
/// part alone, which therefore must be stable by itself: it is the same law at a lower Poisson's ratio, that of lambda
/// - K. K is as large as leaves no negative volume term there:
///
///   law                                          theta    lambda - K at most
///   st_venant_kirchhoff                          tr E     0
///   signed_st_venant_kirchhoff                   sum e_i  0        e_i: its strains of the principal directions
///   stable_neo_hookean, neo_hookean              J - 1    0
///   mooney_rivlin                                J - 1    2 r mu   k = 0
///   squared                                      J - 1    2/3 mu   k = 0
///
/// Where lambda is not above that, K = 0 and nothing is averaged.
struct VolumeSplit {
  Material pointwise;  // with lambda - K
  double bulk;         // K [Pa]
};
VolumeSplit volume_split(const Material& material);

/// Factor of the damping, at most 1, of a tet with Green strain E_n at the start of a step. D : (E - E_n)/h resists a
/// change of F in proportion to |F|^2: a law whose stiffness does not follow has it divided by |F_n|^2 / 3 = 1 + 2/3 tr
/// E_n where that is above 1, so that drawn-out tets do not creep for seconds.
double damping_share(MaterialModel model, const Eigen::Matrix3d& previous_strain);

/// lambda of the viscosity [Pa], at most that of this Poisson's ratio with the tissue's mu. D acts on the trace of E,
/// which changes with the square of a stretch even where the volume stays: a lambda of hundreds of mu would hold the
/// shape of tissue that it should only keep from changing its volume.
constexpr double kMostViscousRatio = 0.46;
double viscous_lambda(const Material& material);

bool reads(MaterialModel model, std::string_view field);  // of Material, by its name in visit_material()

}  // namespace fascia
