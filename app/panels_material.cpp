// Sliders of every material of the scene, made from the material table.
#include <imgui.h>

#include <cstring>

#include "app/panels.h"
#include "app/ui_style.h"
#include "app/ui_widgets.h"

namespace fascia {
namespace {

// What the table does not say: the name for people, the range that a slider is useful in, and what the choice costs.
struct Extra {
  const char* name;
  const char* label;
  double min, max;
  bool logarithmic;
  const char* cost;
};
constexpr Extra kExtras[] = {
    {"young_modulus", "Young's modulus", 1e3, 1e10, true,
     "Fat and brain about 1 to 10 kPa, muscle 10 to 100 kPa, ligament 0.1 to 1 GPa. Costs nothing, but stiffer tissue "
     "needs more iterations to act as stiff as it is."},
    {"poisson_ratio", "Poisson's ratio", -0.9, 0.499, false,
     "Most soft tissue is near 0.45. Costs nothing; above 0.45 linear tets lock and move too little."},
    {"density", "Density", 100, 20000, true, "Water has 1000. Costs nothing; heavier tissue sags more and swings slower."},
    {"damping", "Damping", 0, 1, true, "0 leaves only the damping of the time step. Turning it on costs a few percent of a step."},
};

const char* label_of_model(MaterialModel model) {
  switch (model) {
    case MaterialModel::signed_st_venant_kirchhoff: return "St. Venant-Kirchhoff";
    case MaterialModel::st_venant_kirchhoff: return "St. Venant-Kirchhoff, plain";
    case MaterialModel::stable_neo_hookean: return "Neo-Hookean, stable";
  }
  return "";
}

const char* help_of_model(MaterialModel model) {
  switch (model) {
    case MaterialModel::signed_st_venant_kirchhoff:
      return "Linear in the Green strain; goes on resisting where it is compressed below 60 % or turned inside out, and so comes back.";
    case MaterialModel::st_venant_kirchhoff:
      return "Linear in the Green strain to the end: softens under strong compression, and is content inside out.";
    case MaterialModel::stable_neo_hookean:
      return "Rubber (Smith, de Goes, Kim 2018): softer than the others in tension, stiffer in compression, comes back from inside out. "
             "For two_level and vertex_descent.";
  }
  return "";
}

const Extra* extra_of(const char* name) {
  for (const Extra& extra : kExtras)
    if (std::strcmp(extra.name, name) == 0) return &extra;
  return nullptr;
}

void material_sliders(Simulation& simulation, std::size_t index) {
  Material material = simulation.model.materials[index];
  bool changed = false;
  visit_material(material, [&](double& value, const char* name, const char* unit, double min, double max, bool logarithmic,
                               const char* help) {
    const Extra* extra = extra_of(name);
    const ui::NumberField field{extra ? extra->label : name,
                                unit,
                                extra ? extra->min : min,
                                extra ? extra->max : max,
                                min,
                                max,
                                extra ? extra->logarithmic : logarithmic,
                                false,
                                std::string(help) + (extra ? std::string(". ") + extra->cost : "")};
    changed |= ui::number(field, value);
  });
  std::vector<MaterialModel> able;
  for (const MaterialModel model : material_models())
    if (carries(simulation.scene.solver.method, model)) able.push_back(model);
  changed |= ui::choice("Model", able, material.model, label_of_model, help_of_model);
  if (changed) simulation.set_material(index, material);
}

}  // namespace

void material_panel(Simulation& simulation, const SceneFacts& facts) {
  std::vector<std::size_t> used;
  for (std::size_t m = 0; m < facts.material_volume.size(); ++m)
    if (facts.material_volume[m] > 0) used.push_back(m);
  if (used.size() == 1) {
    material_sliders(simulation, used.front());
    return;
  }
  if (!ImGui::BeginTabBar("regions", ImGuiTabBarFlags_FittingPolicyScroll)) return;
  for (const std::size_t m : used) {
    ImGui::PushID(static_cast<int>(m));
    if (ImGui::BeginTabItem(facts.material_names[m].c_str())) {
      material_sliders(simulation, m);
      ImGui::EndTabItem();
    }
    ImGui::PopID();
  }
  ImGui::EndTabBar();
}

}  // namespace fascia
