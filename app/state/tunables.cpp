#include "app/state/tunables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <optional>
#include <set>
#include <type_traits>

#include "app/ui/field_labels.h"
#include "app/ui/units.h"
#include "sim/material/tissue_looks.h"
#include "sim/material/tissues.h"
#include "sim/model/region_materials.h"
#include "sim/scene/scene_write.h"

namespace fascia {
namespace {

class ChangeList {
 public:
  void add(const std::string& what, const std::string& from, const std::string& to) {
    lines.push_back(what + ": " + from + " to " + to);
  }
  template <class Value>
  void number(const std::string& what, const Value& from, const Value& to, const std::string& unit) {
    if (from == to) return;
    // More digits if three would not show the difference.
    int digits = 3;
    while (digits < 9 && engineering(double(from), unit, digits) == engineering(double(to), unit, digits)) ++digits;
    add(what, engineering(double(from), unit, digits), engineering(double(to), unit, digits));
  }
  std::vector<std::string> lines;
};

/// Visits the table's fields of both in parallel: f(from, to, name, unit).
template <class Visit, class F>
void visit_both(Visit visit, F f) {
  std::vector<double> values;
  visit(false, [&](const auto& value, auto&&...) { values.push_back(double(value)); });
  std::size_t next = 0;
  visit(true, [&](const auto& value, const char* name, const char* unit, auto&&...) {
    f(values[next++], double(value), name, unit);
  });
}

void compare_settings(const SolverSettings& from, const SolverSettings& to, ChangeList& list) {
  if (from.method != to.method) list.add("Method", label_of(from.method), label_of(to.method));
  if (from.acceleration != to.acceleration)
    list.add("Acceleration", label_of(from.acceleration), label_of(to.acceleration));
  if (from.integrator != to.integrator) list.add("Integrator", label_of(from.integrator), label_of(to.integrator));
  visit_both(
      [&](bool second, auto f) { visit_settings(second ? to : from, f); },
      [&](double a, double b, const char* name, const char* unit) { list.number(label_of_field(name), a, b, unit); });
}

void compare_materials(const Material& from, const Material& to, const std::string& where, ChangeList& list) {
  const Tissue* tissue = tissue_of(to);
  Material like = to;
  like.damping = from.damping;
  like.model = from.model;
  like.look = from.look;
  like.color = from.color;
  const bool other_tissue = tissue && like != from;
  if (other_tissue) {
    list.add("Tissue" + where, tissue_of(from) ? tissue_of(from)->label : "own values", tissue->label);
  } else {
    visit_both([&](bool second, auto f) { visit_material(second ? to : from, f); },
               [&](double a, double b, const char* name, const char* unit) {
                 if (std::strcmp(name, "damping") != 0) list.number(label_of_field(name) + where, a, b, unit);
               });
  }
  list.number(label_of_field("damping") + where, from.damping, to.damping, "s");
  if (from.model != to.model) list.add("Model" + where, name_of(from.model), name_of(to.model));
  if (from.look != to.look && !other_tissue) {
    const auto label = [](const TissueLook* look) { return (look ? look : &tissue_looks().front())->label; };
    list.add("Look" + where, label(from.look), label(to.look));
  }
  if (from.color != to.color) {
    const auto text = [](const Material& material) {
      if (!material.color) return std::string("that of the look");
      char hex[8];
      const auto& [red, green, blue] = *material.color;
      const auto byte = [](double share) { return static_cast<int>(std::lround(255 * share)); };
      std::snprintf(hex, sizeof hex, "#%02x%02x%02x", byte(red), byte(green), byte(blue));
      return std::string(hex);
    };
    list.add("Color" + where, text(from), text(to));
  }
}

void compare_entries(const MaterialEntries& from, const MaterialEntries& to, bool only_body, const std::string& body,
                     ChangeList& list) {
  const std::string of_body = only_body ? "" : ", " + body;
  const auto find = [](const MaterialEntries& entries, const std::string& key) -> const MaterialOverride* {
    for (const auto& [name, values] : entries.region_materials)
      if (name == key) return &values;
    return nullptr;
  };
  compare_materials(from.material, to.material, of_body + (to.region_materials.empty() ? "" : ", default"), list);
  for (const auto& [key, values] : to.region_materials) {
    const MaterialOverride* before = find(from, key);
    if (!before) list.lines.push_back("A material of its own" + of_body + ", " + key);
    compare_materials(before ? with_override(from.material, *before) : from.material,
                      with_override(to.material, values), of_body + ", " + key, list);
  }
  for (const auto& [key, values] : from.region_materials)
    if (!find(to, key)) list.lines.push_back("The default material" + of_body + ", " + key);
}

/// "57 vertices", or the number of selections where they are not lists of vertices.
std::string fixed_text(const FixedSets& sets) {
  std::size_t vertices = 0, others = 0;
  for (const auto& body : sets)
    for (const Selection& selection : body) {
      if (const auto* list = std::get_if<VertexSelection>(&selection))
        vertices += list->vertices.size();
      else
        ++others;
    }
  const std::string listed = std::to_string(vertices) + (vertices == 1 ? " vertex" : " vertices");
  if (others == 0) return listed;
  return std::to_string(others) + (others == 1 ? " selection" : " selections") + (vertices > 0 ? ", " + listed : "");
}

std::size_t tets_in(const RegionSets& sets, const std::string& name) {
  std::size_t tets = 0;
  for (const auto& body : sets)
    for (const TetRegion& region : body)
      if (region.name == name)
        for (const TetRange& range : region.tets) tets += range.last - range.first + 1;
  return tets;
}

void compare_regions(const RegionSets& from, const RegionSets& to, ChangeList& list) {
  std::set<std::string> names;
  for (const RegionSets* sets : {&from, &to})
    for (const auto& body : *sets)
      for (const TetRegion& region : body) names.insert(region.name);
  for (const std::string& name : names)
    if (const std::size_t before = tets_in(from, name), after = tets_in(to, name); before != after)
      list.add("Painted, " + name, std::to_string(before), std::to_string(after) + (after == 1 ? " tet" : " tets"));
}

void compare_instruments(const std::vector<Instrument>& from, const std::vector<Instrument>& to, ChangeList& list) {
  const auto has = [](const std::vector<Instrument>& instruments, const std::string& name) {
    return std::any_of(instruments.begin(), instruments.end(), [&](const Instrument& i) { return i.name == name; });
  };
  for (const Instrument& instrument : to)
    if (!has(from, instrument.name)) list.lines.push_back("Instrument added: " + instrument.name);
  for (const Instrument& instrument : from)
    if (!has(to, instrument.name)) list.lines.push_back("Instrument taken away: " + instrument.name);
}

/// Compares every display key in its scene-file form, so that new keys are included automatically.
void compare_display(const DisplaySettings& from, const DisplaySettings& to, ChangeList& list) {
  const auto document = [](const DisplaySettings& display) {
    Scene scene;
    scene.display = display;
    return scene_document(scene, "").at("display");
  };
  const nlohmann::ordered_json before = document(from), after = document(to);
  const auto text = [](const nlohmann::ordered_json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
  };
  for (const auto& [key, value] : after.items()) {
    const bool had = before.contains(key);
    if (!had || before.at(key) != value)
      list.add(label_of_field(key), had ? text(before.at(key)) : "automatic", text(value));
  }
  for (const auto& [key, value] : before.items())
    if (!after.contains(key)) list.add(label_of_field(key), text(value), "automatic");
}

}  // namespace

Tunables tunables_of(const Session& session, const GrabSettings& grab) {
  const Simulation& simulation = session.simulation;
  return {simulation.scene.solver,
          material_entries(simulation.scene, simulation.model, simulation.model.materials),
          fixed_of(simulation.scene),
          painted_of(simulation.scene),
          elements_of(simulation.scene),
          simulation.scene.tools.instruments,
          simulation.scene.gravity,
          simulation.scene.display,
          grab};
}

void set_tunables(Session& session, GrabSettings& grab, const Tunables& tunables) {
  Simulation& simulation = session.simulation;
  const Tunables now = tunables_of(session, grab);
  // A method must support the current materials: methods that support every law are set first.
  const bool settings_first = std::all_of(simulation.model.materials.begin(), simulation.model.materials.end(),
                                          [&](const Material& m) { return carries(tunables.solver.method, m.model); });
  if (now.solver != tunables.solver && settings_first) simulation.set_settings(tunables.solver);
  if (now.materials != tunables.materials) session.set_material_entries(tunables.materials);
  if (now.solver != tunables.solver && !settings_first) simulation.set_settings(tunables.solver);
  if (now.gravity != tunables.gravity) simulation.set_gravity(tunables.gravity);
  if (now.display != tunables.display) session.set_display(tunables.display);
  grab = tunables.grab;
}

std::vector<std::string> changes(const Tunables& from, const Tunables& to) {
  ChangeList list;
  compare_settings(from.solver, to.solver, list);
  compare_regions(from.regions, to.regions, list);
  for (std::size_t b = 0; b < std::min(from.materials.size(), to.materials.size()); ++b)
    compare_entries(from.materials[b], to.materials[b], to.materials.size() == 1, "body " + std::to_string(b), list);
  for (std::size_t b = 0; b < std::min(from.elements.size(), to.elements.size()); ++b)
    if (from.elements[b] != to.elements[b])
      list.add(to.elements.size() == 1 ? "Elements" : "Elements, body " + std::to_string(b), name_of(from.elements[b]),
               name_of(to.elements[b]));
  compare_instruments(from.instruments, to.instruments, list);
  if (from.fixed != to.fixed) list.add("Fixed", fixed_text(from.fixed), fixed_text(to.fixed));
  for (int axis = 0; axis < 3; ++axis)
    list.number(std::string("Gravity ") + "xyz"[axis], from.gravity[axis], to.gravity[axis], "m/s^2");
  compare_display(from.display, to.display, list);
  list.number("Grab radius", 100 * from.grab.radius, 100 * to.grab.radius, "%");
  list.number("Grip", from.grab.grip, to.grab.grip, "");
  if (list.lines.empty() && from != to)
    list.lines.push_back(from.regions != to.regions ? "Painted other tets" : "A value of the display or the grab");
  return list.lines;
}

}  // namespace fascia
