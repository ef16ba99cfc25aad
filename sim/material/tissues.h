// Tissues with values from the literature, one table: presets of the panel, of scene files ("preset": "liver") and of
// --set, and the listing of `fascia info --tissues`. The isotropic, linear stand-in for something that is neither: each
// entry says how it was measured and how far values of others lie from it.
#pragma once
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "sim/material/material.h"

namespace fascia {

struct Tissue {
  const char* name;      // "liver", as in scene files
  const char* label;     // for people: "Liver"
  double young_modulus;  // [Pa] at small strain
  double poisson_ratio;  // [-] 0.45 where the tissue is nearly incompressible: 0.49 would be physical, but locks linear
                         // tets
  double density;        // [kg/m^3] ICRU Report 46 (1992); what it does not list after the IT'IS tissue database
  double least, most;    // [Pa] that measurements of healthy tissue commonly span, methods and loads included
  const char* conditions;  // of the measurement that young_modulus is from
  const char* source;      // author, year, title, journal
};

const std::vector<Tissue>& tissues();              // by organ, soft ones first
const Tissue* find_tissue(std::string_view name);  // null if there is none of that name
std::vector<std::string> tissue_names();

/// Modulus, Poisson's ratio and density become the tissue's; damping and model stay.
void apply(const Tissue& tissue, Material& material);
/// The tissue whose values a material has; null for values of one's own.
const Tissue* tissue_of(const Material& material);
/// What a user should know before using it: range, conditions, note on Poisson's ratio, source. Some lines.
std::string about(const Tissue& tissue);

/// A table with sources, for a terminal.
void print_tissues(std::ostream& out);

}  // namespace fascia
