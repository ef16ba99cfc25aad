// Isotropic tissue materials.
#pragma once
#include <string>
#include <vector>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// Values out of range are an Error of the call that is given them.
  struct Material {
    double young_modulus = 1e5;  // E [Pa], 1e-3 to 1e14
    double poisson_ratio = 0.3;  // nu [-], -0.9 to 0.499; above 0.45 linear tets are visibly too stiff
    double density = 1000;       // [kg/m^3], 1e-3 to 1e6
    double damping = 0;          // viscosity over stiffness [s], 0 to 10 (Kelvin-Voigt)
    std::string model = "signed_st_venant_kirchhoff";  // one of material_models()
    double mooney_ratio = 0.2;  // C01 / (C10 + C01) of the model mooney_rivlin, 0 to 1; other models do not read it
    bool operator==(const Material&) const = default;
  };

  /// The names of the laws, as in scene files.
  FASCIA_EXPORT std::vector<std::string> material_models();

  /// Modulus, Poisson's ratio and density of a tissue from the literature ("liver", as in scene files); no damping.
  /// Throws Error that lists the names for one that is unknown.
  FASCIA_EXPORT Material tissue(const std::string& name);
  FASCIA_EXPORT std::vector<std::string> tissues();

}  // namespace api
}  // namespace fascia
