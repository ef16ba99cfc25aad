// Isotropic tissue material: the parameters that a user sets, and the constants that follow.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fascia {

/// The laws (sim/material/law.h) by name. signed_st_venant_kirchhoff is St. Venant-Kirchhoff where no direction is
/// compressed below 0.6, and keeps resisting where one is.
enum class MaterialModel {
  signed_st_venant_kirchhoff,
  st_venant_kirchhoff,
  stable_neo_hookean,
  neo_hookean,
  mooney_rivlin,
  squared
};

const std::vector<MaterialModel>& material_models();  // all of them
const char* name_of(MaterialModel model);             // "st_venant_kirchhoff", as in scene files
std::optional<MaterialModel> find_material_model(std::string_view name);

/// Above this value linear tets are visibly too stiff on any affordable mesh.
inline constexpr double kLockingPoissonRatio = 0.45;

struct TissueLook;

struct Material {
  double young_modulus = 1e5;  // E [Pa]
  double poisson_ratio = 0.3;  // nu [-], -0.9 to 0.499
  double density = 1000;       // [kg/m^3]
  double damping = 0;          // ratio of viscosity to stiffness [s] (Kelvin-Voigt: S = D (eps + damping * d eps/dt))
  MaterialModel model = MaterialModel::signed_st_venant_kirchhoff;
  double mooney_ratio = 0.2;  // for mooney_rivlin only: C01 / (C10 + C01) [-]
  // In pictures:
  const TissueLook* look = nullptr;                           // a row of tissue_looks(); null: the first one
  std::optional<std::array<double, 3>> color = std::nullopt;  // sRGB, 0 to 1; absent: that of the look

  double lame_lambda() const { return young_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio)); }
  double lame_mu() const { return young_modulus / (2 * (1 + poisson_ratio)); }
  bool operator==(const Material&) const = default;
};

/// The table of a Material's numbers: f(field, name, unit, min, max, logarithmic, help). The JSON reader, --set, the
/// sliders and the provenance stamp are all generated from it.
template <class M, class F>
void visit_material(M& m, F&& f) {
  f(m.young_modulus, "young_modulus", "Pa", 1e-3, 1e14, true, "stiffness: stress per strain under uniaxial load");
  f(m.poisson_ratio, "poisson_ratio", "", -0.9, 0.499, false,
    "how much a pulled piece thins; near 0.5 it keeps its volume");
  f(m.density, "density", "kg/m^3", 1e-3, 1e6, true, "mass per volume at rest");
  f(m.damping, "damping", "s", 0.0, 10.0, false,
    "viscosity over stiffness: motion of period T decays faster the nearer this is to T");
  f(m.mooney_ratio, "mooney_ratio", "", 0.0, 1.0, false,
    "C01 / (C10 + C01) of the model mooney_rivlin, which alone reads it");
}

}  // namespace fascia
