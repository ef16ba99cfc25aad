// Isotropic tissue materials and the table of tissues.
#pragma once
#include <string>
#include <vector>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// An isotropic material. A call that receives a value out of range throws Error.
  struct Material {
    /// Young's modulus E [Pa], 1e-3 to 1e14.
    double young_modulus = 1e5;
    /// Poisson's ratio nu [-], -0.9 to 0.499. Above 0.45 linear tets are visibly too stiff.
    double poisson_ratio = 0.3;
    /// The density at rest [kg/m^3], 1e-3 to 1e6.
    double density = 1000;
    /// The Kelvin-Voigt damping: viscosity over stiffness [s], 0 to 10.
    double damping = 0;
    /// The law: one of material_models().
    std::string model = "signed_st_venant_kirchhoff";
    /// The ratio C01 / (C10 + C01) [-] of the law "mooney_rivlin", 0 to 1. Other laws do not read it.
    double mooney_ratio = 0.2;
    bool operator==(const Material&) const = default;
  };

  /// Returns the names of the laws, as in scene files.
  FASCIA_EXPORT std::vector<std::string> material_models();

  /// Returns Young's modulus, Poisson's ratio and density of a tissue from the literature, without damping. `name` is
  /// one of tissues(). Throws Error for an unknown name; the message lists the known ones.
  FASCIA_EXPORT Material tissue(const std::string& name);
  /// Returns the names of the tissues, as in scene files, for example "liver".
  FASCIA_EXPORT std::vector<std::string> tissues();

}  // namespace api
}  // namespace fascia
