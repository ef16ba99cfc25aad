// Regions and materials: the share of each material in the tissue, and the sliders of the chosen material, made from
// the material table.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "app/panels/panels.h"
#include "app/session/advice.h"
#include "app/ui/field_labels.h"
#include "app/ui/style.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"
#include "render/view/color_map.h"
#include "sim/material/law.h"
#include "sim/material/tissue_looks.h"
#include "sim/material/tissues.h"

namespace fascia {
namespace {

// Data beside the table: the useful range of a slider, the smallest value that may be typed, and the cost of the
// choice.
struct Extra {
  const char* name;
  double min, max, least;
  bool logarithmic;
  const char* cost;
};
constexpr Extra kExtras[] = {
    {"young_modulus", 100, 1e9, 1, true,
     "Fat and brain about 1 to 10 kPa, muscle 10 to 100 kPa, ligament 0.1 to 1 GPa. Costs nothing, but stiffer tissue "
     "needs more iterations to reach its stiffness."},
    {"poisson_ratio", -0.9, 0.499, -1, false,
     "Most soft tissue is near 0.45. Costs nothing; above 0.45 linear tets lock and move too little."},
    {"density", 100, 20000, 0, true, "Water has 1000. Costs nothing; heavier tissue sags more and swings slower."},
    {"damping", 0, 1, 0, true,
     "0 leaves only the damping of the time step. Turning it on costs a few percent of a step."},
};

constexpr float kTissueList = 400;  // width of the list of tissues [points]

const char* label_of_model(MaterialModel model) { return law_of(model).label; }
const char* help_of_model(MaterialModel model) { return law_of(model).help; }
std::string refusal_of_model(Method method, MaterialModel model) {
  return carries(method, model)
             ? ""
             : std::string("The method ") + label_of(method) +
                   " runs St. Venant-Kirchhoff alone: choose another method first, in the panel Solver.";
}

const Extra* extra_of(const char* name) {
  for (const Extra& extra : kExtras)
    if (std::strcmp(extra.name, name) == 0) return &extra;
  return nullptr;
}

std::string label_of_tissue(const Tissue* tissue) { return tissue ? tissue->label : "own values"; }
std::string help_of_tissue(const Tissue* tissue) {
  return tissue ? std::string(tissue->label) + ": " + about(*tissue)
                : "Values of a tissue from the literature, with their source: Young's modulus, Poisson's ratio and "
                  "density. Damping stays; so does the model, except that St. Venant-Kirchhoff becomes squared "
                  "neo-Hookean. Costs nothing.";
}

// A row of the list: name and values in columns; true if it was clicked.
bool tissue_row(const Tissue& tissue, bool chosen) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const bool clicked = ImGui::Selectable(tissue.label, chosen, ImGuiSelectableFlags_SpanAllColumns);
  if (chosen && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
  ui::tooltip(help_of_tissue(&tissue));
  for (const std::string& value : {engineering(tissue.young_modulus, "Pa"), engineering(tissue.poisson_ratio, ""),
                                   engineering(tissue.density, "")}) {
    ImGui::TableNextColumn();
    const float free = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(value.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, free));
    ImGui::TextColored(ui::kDim, "%s", value.c_str());
  }
  return clicked;
}

// Of a scene whose method carries it, the law of tissues replaces the one of scene files that name none; another law
// was chosen and stays.
bool tissue_combo(Material& material, Method method, std::optional<MaterialModel>& replaced) {
  const Tissue* const now = tissue_of(material);
  const Tissue* chosen = nullptr;
  ui::label("Tissue", help_of_tissue(now));
  ImGui::SetNextWindowSizeConstraints({ui::px(kTissueList), 0}, {ui::px(kTissueList), ui::px(340)});
  if (!ImGui::BeginCombo("##tissue", label_of_tissue(now).c_str(), ImGuiComboFlags_HeightLargest)) {
    ui::tooltip(help_of_tissue(now));
    return false;
  }
  if (ImGui::BeginTable("tissues", 4)) {
    ImGui::TableSetupColumn("Tissue", ImGuiTableColumnFlags_WidthStretch);
    for (const char* head : {"E", "nu", "kg/m\xc2\xb3"})
      ImGui::TableSetupColumn(head, ImGuiTableColumnFlags_WidthFixed, ImGui::CalcTextSize("00.0 kPa").x);
    ImGui::TableHeadersRow();
    for (const Tissue& tissue : tissues())
      if (tissue_row(tissue, &tissue == now)) chosen = &tissue;
    ImGui::EndTable();
  }
  ImGui::EndCombo();
  if (!chosen || chosen == now) return false;
  apply(*chosen, material);
  if (material.model == Material().model && carries(method, kTissueLaw)) {
    replaced = material.model;
    material.model = kTissueLaw;
  }
  return true;
}

// Says that a tissue has replaced the law, with a button that takes it back.
bool replaced_law_row(WindowState& state, Material& material) {
  if (!state.replaced_law || state.replaced_law->material != state.chosen_material) return false;
  const char* const before = law_of(state.replaced_law->before).label;
  if (material.model != kTissueLaw) state.replaced_law.reset();
  const Hint hint{"replaced law", std::string("The model is now ") + law_of(kTissueLaw).label + ".",
                  std::string("Tissues come with it, since soft bodies of ") + before +
                      " collapse under their own weight. XPBD methods run only the latter.",
                  std::string("Back to ") + before, true};
  if (!state.replaced_law || !hint_row(state.hints, hint)) return false;
  material.model = state.replaced_law->before;
  state.replaced_law.reset();
  return true;
}

const char* label_of_look(const TissueLook* look) { return look->label; }
std::string help_of_look(const TissueLook*) {
  return "How the tissue looks in pictures: its colors, vessels, bumps and wetness. A tissue of the list above sets "
         "it. Costs nothing";
}

// The color of the look, until another one is chosen.
bool color_row(const TissueLook& look, Material& material) {
  const char* const help =
      "Color of the tissue in pictures, instead of that of its look. Heat maps and the colors of regions stay";
  ui::label("Color", help);
  bool own = material.color.has_value();
  bool changed = ImGui::Checkbox("##own color", &own);
  ui::tooltip(help);
  std::array<float, 3> shown = look.color;
  for (std::size_t i = 0; own && material.color && i < 3; ++i) shown[i] = static_cast<float>((*material.color)[i]);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-FLT_MIN);
  const bool picked = ImGui::ColorEdit3("##color", shown.data(), ImGuiColorEditFlags_NoInputs);
  ui::tooltip(help);
  if (picked) changed = own = true;
  if (!changed) return false;
  material.color.reset();
  if (own) {
    // Distinguishes all colors of a picture, in short numbers of a scene file
    const auto rounded = [](float share) { return std::round(1e4 * share) / 1e4; };
    material.color = {rounded(shown[0]), rounded(shown[1]), rounded(shown[2])};
  }
  return true;
}

bool look_rows(Material& material) {
  std::vector<const TissueLook*> looks;
  for (const TissueLook& look : tissue_looks()) looks.push_back(&look);
  const TissueLook* look = material.look ? material.look : looks.front();
  const bool chosen = ui::choice("Look", looks, look, label_of_look, help_of_look);
  if (chosen) material.look = look;
  return color_row(*look, material) || chosen;
}

// Nothing for a body of quadratic elements.
void locking_row(const PanelContext& context, std::size_t index, double poisson_ratio) {
  const Simulation& simulation = context.session.simulation;
  const std::vector<BodyPart>& parts = simulation.model.bodies;
  const auto body = static_cast<std::size_t>(
      std::find_if(parts.begin(), parts.end(),
                   [&](const BodyPart& part) { return index < part.material_begin + part.material_count; }) -
      parts.begin());
  ElementOrders elements = elements_of(simulation.scene);
  if (body >= elements.size() || elements[body] == ElementOrder::quadratic) return;
  const bool remedy = info_of(simulation.scene.solver.method).carries_quadratic;
  if (!hint_row(context.state.hints, locking_hint(poisson_ratio, remedy))) return;
  elements[body] = ElementOrder::quadratic;
  context.requests.elements = std::move(elements);
}

void material_sliders(const PanelContext& context) {
  Simulation& simulation = context.session.simulation;
  WindowState& state = context.state;
  const std::size_t index = state.chosen_material;
  const Method method = simulation.scene.solver.method;
  Material material = simulation.model.materials[index];
  std::optional<MaterialModel> replaced;
  bool changed = tissue_combo(material, method, replaced);
  if (replaced) state.replaced_law = {index, *replaced};
  visit_material(material, [&](double& value, const char* name, const char* unit, double min, double max,
                               bool logarithmic, const char* help) {
    if (!reads(material.model, name)) return;
    const Extra* extra = extra_of(name);
    const ui::NumberField field{label_of_field(name),
                                unit,
                                extra ? extra->min : min,
                                extra ? extra->max : max,
                                extra ? std::max(min, extra->least) : min,
                                max,
                                extra ? extra->logarithmic : logarithmic,
                                false,
                                std::string(help) + (extra ? std::string(". ") + extra->cost : ""),
                                std::strcmp(name, "damping") == 0 ? "off" : ""};
    changed |= ui::number(field, value);
    if (std::strcmp(name, "poisson_ratio") == 0) locking_row(context, index, value);
  });
  changed |= ui::choice("Model", material_models(), material.model, label_of_model, help_of_model,
                        [&](MaterialModel model) { return refusal_of_model(method, model); });
  changed |= replaced_law_row(state, material);
  changed |= look_rows(material);
  if (changed) simulation.set_material(index, material);
}

// A patch of the region's color in pictures.
void swatch(std::size_t region) {
  const float size = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Eigen::Vector3f color = region_color(static_cast<unsigned>(region));
  ImGui::GetWindowDrawList()->AddRectFilled({corner.x, corner.y + 0.15f * size},
                                            {corner.x + 0.7f * size, corner.y + 0.85f * size},
                                            ImGui::GetColorU32(ImVec4(color.x(), color.y(), color.z(), 1)));
  ImGui::Dummy({0.7f * size, size});
  ImGui::SameLine();
}

void text_right(const std::string& text, float end) {
  ImGui::SameLine(end - ImGui::CalcTextSize(text.c_str()).x);
  ImGui::PushStyleColor(ImGuiCol_Text, ui::kDim);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

std::string percent_text(double share) {
  char text[16];
  std::snprintf(text, sizeof text, share < 0.0995 ? "%.2g %%" : "%.0f %%", 100 * share);
  return text;
}

// The scene's entries with the entry of a region added or removed.
std::vector<MaterialEntries> with_region(const Simulation& simulation, const SceneFacts::Region& region, bool own) {
  std::vector<MaterialEntries> all = material_entries(simulation.scene, simulation.model, simulation.model.materials);
  auto& entries = all[region.body].region_materials;
  // The name may belong to several regions
  const std::string& name = simulation.model.bodies[region.body].regions.at(region.number);
  std::erase_if(entries, [&](const auto& entry) {
    return entry.first == region.key || entry.first == std::to_string(region.number) || entry.first == name;
  });
  if (own) entries.emplace_back(region.key, MaterialOverride{});
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return all;
}

// One line: color, name, share of the volume. A click chooses the material. A region without its own material has a
// button that adds one.
void region_row(const Simulation& simulation, const SceneFacts& facts, std::size_t index, std::size_t& chosen,
                Requests& requests) {
  const SceneFacts::Region& region = facts.regions[index];
  const Model& model = simulation.model;
  const bool own = region.material != model.bodies[region.body].material_begin;
  const float end = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x,
              button = ImGui::CalcTextSize("share").x + ui::px(12);
  swatch(index);
  if (ImGui::Selectable((region.label + "##region").c_str(), chosen == region.material,
                        ImGuiSelectableFlags_AllowItemOverlap,
                        {ImGui::GetContentRegionAvail().x - button - ui::px(6), 0}))
    chosen = region.material;
  ui::tooltip("Region " + std::to_string(region.number) + ", " + engineering(1e6 * region.volume, "ml") + ", " +
              engineering(region.volume * model.materials[region.material].density, "kg") +
              (own ? ". Has its own material" : ". Has the default material, as all regions without their own"));
  text_right(percent_text(region.volume / facts.volume), end - button - ui::px(6));
  ImGui::SameLine(end - button);
  if (ui::small_button(own ? "share" : "own",
                       own ? "Removes the region's own material: the region has the default again. The solver is "
                             "rebuilt, the state stays"
                           : "Gives the region its own material, which starts as the default and is saved with "
                             "the scene. The solver is rebuilt, the state stays",
                       button))
    requests.materials = with_region(simulation, region, !own);
}

}  // namespace

void material_panel(const PanelContext& context) {
  Simulation& simulation = context.session.simulation;
  WindowState& state = context.state;
  const SceneFacts& facts = state.facts;
  std::vector<std::size_t> used;
  for (std::size_t m = 0; m < facts.material_volume.size(); ++m)
    if (facts.material_volume[m] > 0) used.push_back(m);
  if (used.empty()) return;
  if (std::find(used.begin(), used.end(), state.chosen_material) == used.end()) state.chosen_material = used.front();
  if (facts.regions.size() > 1) {
    constexpr std::size_t kMostRows = 7;  // further rows scroll
    const bool scrolls = facts.regions.size() > kMostRows;
    if (scrolls) ImGui::BeginChild("regions", {0, kMostRows * ImGui::GetTextLineHeightWithSpacing()});
    for (std::size_t r = 0; r < facts.regions.size(); ++r) {
      ImGui::PushID(static_cast<int>(r));
      region_row(simulation, facts, r, state.chosen_material, context.requests);
      ImGui::PopID();
    }
    if (scrolls) ImGui::EndChild();
    const double volume = facts.material_volume[state.chosen_material];
    ui::fact(
        facts.material_names[state.chosen_material].c_str(),
        percent_text(volume / facts.volume) + ", " +
            engineering(volume * simulation.model.materials[state.chosen_material].density, "kg"),
        "The material that the sliders below change: its share of the volume, and its mass at the current density");
  }
  material_sliders(context);
}

}  // namespace fascia
