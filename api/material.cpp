#include "api/material.h"

#include "api/values.h"
#include "sim/material/tissues.h"

namespace fascia::api {
namespace {

std::string list_of(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

fascia::Material checked(const Material& material, const std::string& where) {
  const std::optional<MaterialModel> model = find_material_model(material.model);
  if (!model)
    throw Error(where + ".model", "is \"" + material.model + "\"", "expected one of " + list_of(material_models()));
  const fascia::Material own{material.young_modulus, material.poisson_ratio, material.density, material.damping, *model,
                             material.mooney_ratio};
  visit_material(own, RangeCheck{where});
  return own;
}

Material shown(const fascia::Material& material) {
  return {material.young_modulus, material.poisson_ratio,  material.density,
          material.damping,       name_of(material.model), material.mooney_ratio};
}

std::vector<std::string> material_models() {
  std::vector<std::string> names;
  for (const MaterialModel model : fascia::material_models()) names.emplace_back(name_of(model));
  return names;
}

Material tissue(const std::string& name) {
  const Tissue* found = find_tissue(name);
  if (!found) throw Error("tissue \"" + name + "\"", "is unknown", "expected one of " + list_of(tissues()));
  fascia::Material material;
  apply(*found, material);
  return shown(material);
}

std::vector<std::string> tissues() { return tissue_names(); }

}  // namespace fascia::api
