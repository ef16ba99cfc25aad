// Tissues with values from the literature, in one table: presets of the panel, of scene files ("preset": "liver") and
// of --set, and the listing of `fascia info --tissues`. Each is an isotropic, linear approximation of a tissue that is
// neither; each entry states how the values were measured and how far published values spread.
#pragma once
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "sim/material/material.h"

namespace fascia {

/// The law of tissue that is not given one: of meshes opened alone and of a tissue chosen in the panel. Scene files
/// that name no law have that of Material.
inline constexpr MaterialModel kTissueLaw = MaterialModel::squared;

struct Tissue {
  const char* name;      // "liver", as in scene files
  const char* label;     // as displayed: "Liver"
  const char* look;      // TissueLook::name
  double young_modulus;  // [Pa] at small strain
  double poisson_ratio;  // [-] 0.45 where the tissue is nearly incompressible: 0.49 would be physical, but locks linear
                         // tets
  double density;      // [kg/m^3] ICRU Report 46 (1992); tissues that it does not list after the IT'IS tissue database
  double least, most;  // [Pa] the common range of measurements of healthy tissue, over all methods and loads
  const char* conditions;  // of the measurement of young_modulus
  const char* source;      // author, year, title, journal
};

const std::vector<Tissue>& tissues();              // by organ, soft ones first
const Tissue* find_tissue(std::string_view name);  // null if there is no such tissue
std::vector<std::string> tissue_names();

/// Modulus, Poisson's ratio, density and look are set to the tissue's; damping, model and color stay unchanged.
void apply(const Tissue& tissue, Material& material);
/// The tissue whose modulus, Poisson's ratio and density a material has; null for custom values.
const Tissue* tissue_of(const Material& material);
/// Information for a user before use: range, conditions, note on Poisson's ratio, source. Several lines.
std::string about(const Tissue& tissue);

/// Prints a table with sources for a terminal.
void print_tissues(std::ostream& out);

}  // namespace fascia
