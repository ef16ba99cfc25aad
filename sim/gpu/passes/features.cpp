#include "sim/gpu/passes/features.h"

#include <cctype>

#include "sim/material/law.h"

namespace fascia {

namespace {

std::string capitals(std::string name) {
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

std::string has_model(const MaterialLaw& law) {
  return "HAS_MODEL(material, " + std::to_string(static_cast<int>(law.model)) + ".0)";
}

// A call of a law's function, selected by the material's law: HAS_MODEL(material, 2.0) ? stable_neo_hookean_block(...)
// : ...
std::string call_of_law(const std::vector<const MaterialLaw*>& laws, const std::string& function) {
  std::string text;
  for (const MaterialLaw* law : laws) {
    if (law != laws.back()) text += has_model(*law) + " ? ";
    text += law->name + function + (law == laws.back() ? "" : " : ");
  }
  return "(" + text + ")";
}

// Whether a material has one of the laws: "true" or "false" if all or none of the scene's laws are among them.
std::string test_of_law(const std::vector<const MaterialLaw*>& among, const std::vector<const MaterialLaw*>& laws) {
  if (among.empty()) return "false";
  if (among.size() == laws.size()) return "true";
  std::string text;
  for (const MaterialLaw* law : among) text += (text.empty() ? "(" : " || ") + has_model(*law);
  return text + ")";
}

}  // namespace

Features features_of(const Model& model) {
  Features features;
  features.quadratic = model.has_quadratic();
  features.material_per_tet = model.materials.size() > 1;
  for (const Material& material : model.materials) {
    features.damping |= material.damping > 0;
    features.models.insert(material.model);
  }
  return features;
}

gl::Defines defines_of(const Features& features) {
  const auto flag = [](bool on) { return on ? "1" : "0"; };
  gl::Defines defines{{"DAMPING", flag(features.damping)},
                      {"MATERIAL_PER_TET", flag(features.material_per_tet)},
                      {"LAW_COUNT", std::to_string(features.models.size())}};
  std::vector<const MaterialLaw*> laws, beyond, fading;
  for (const MaterialLaw* law : material_laws()) {
    const bool has = features.models.contains(law->model);
    defines.emplace_back(capitals(law->name), flag(has));
    if (has) laws.push_back(law);
    if (has && !law->of_strain) beyond.push_back(law);
    if (has && law->fades_damping) fading.push_back(law);
  }
  defines.emplace_back("FADES_DAMPING(material)", test_of_law(fading, laws));
  defines.emplace_back("BEYOND_STRAIN", flag(!beyond.empty()));
  if (beyond.empty()) return defines;
  defines.emplace_back("IS_BEYOND_STRAIN(material)", test_of_law(beyond, laws));
  defines.emplace_back("LAW_RESPONSE(h, material)", call_of_law(beyond, "_response(h, material)"));
  defines.emplace_back("LAW_CURVATURE(h, material, a, b)", call_of_law(beyond, "_curvature(h, material, a, b)"));
  defines.emplace_back("LAW_BLOCK(h, material, b)", call_of_law(beyond, "_block(h, material, b)"));
  if (features.quadratic)
    defines.emplace_back("LAW_POINTWISE_LAMBDA(material)", call_of_law(beyond, "_pointwise_lambda(material)"));
  return defines;
}

gl::ComputePass::Bindings with_material(gl::ComputePass::Bindings bindings, const Features& features,
                                        const SimBuffers& buffers) {
  if (features.material_per_tet) {
    bindings.emplace_back("tet_material", &buffers.tet_material);
    bindings.emplace_back("materials", &buffers.materials);
  }
  return bindings;
}

gl::ComputePass::Bindings with_damping(gl::ComputePass::Bindings bindings, const Features& features,
                                       const gl::Buffer& previous_strain) {
  if (features.damping) bindings.emplace_back("previous_strain", &previous_strain);
  return bindings;
}

std::size_t bytes_of_previous_strain(const gl::ProgramCache& programs, const SimBuffers& buffers) {
  const std::size_t linear = buffers.linear_count(), of_points = std::size_t{8} * buffers.quadratic_count;
  const bool packed = programs.load_path() == gl::LoadPath::storage;
  return sizeof(shared::vec4) * ((packed ? 3 * ((linear + 1) / 2) : 2 * linear) + of_points);
}

gl::ComputePass::Bindings with_pairs(gl::ComputePass::Bindings bindings, const SimBuffers& buffers) {
  bindings.insert(bindings.end(), {{"tet_vertices", &buffers.tet_vertices},
                                   {"tet_shape", &buffers.tet_shape},
                                   {"pair_fifth", &buffers.pair_fifth}});
  return bindings;
}

gl::ComputePass::Constants constants_of_pairs(const SimBuffers& buffers) {
  return {{"pair_count", buffers.pair_count}, {"second_begin", buffers.pair_and_single_count()}};
}

void count_bytes_of_pairs(gl::ComputePass& pass, const SimBuffers& buffers) {
  pass.reads_first("tet_vertices", sizeof(Tet) * buffers.pair_and_single_count());
  pass.reads_first("tet_shape", 3 * sizeof(shared::vec4) * buffers.pair_and_single_count());
}

gl::ComputePass::Bindings with_slots(gl::ComputePass::Bindings bindings, const SimBuffers& buffers) {
  bindings.emplace_back("pair_slots", &buffers.pair_slots);
  bindings.emplace_back("correction", &buffers.correction);
  return with_pairs(std::move(bindings), buffers);
}

gl::ComputePass::Bindings with_quadratic(gl::ComputePass::Bindings bindings, const SimBuffers& buffers) {
  bindings.insert(
      bindings.end(),
      {{"tet_vertices", &buffers.tet_vertices}, {"tet_shape", &buffers.tet_shape}, {"mid_edges", &buffers.mid_edges}});
  return bindings;
}

gl::Defines defines_of_quadratic(gl::Defines defines, const SimBuffers& buffers) {
  if (buffers.has_linear()) defines.emplace_back("MIXED", "1");
  return defines;
}

gl::ComputePass::Constants constants_of_quadratic(const SimBuffers& buffers) {
  if (!buffers.has_linear()) return {};
  return {{"first_quadratic", buffers.linear_count()}};
}

gl::ComputePass::Bindings with_quadratic_slots(gl::ComputePass::Bindings bindings, const SimBuffers& buffers) {
  bindings.emplace_back("quadratic_slots", &buffers.quadratic_slots);
  bindings.emplace_back("correction", &buffers.correction);
  return with_quadratic(std::move(bindings), buffers);
}

}  // namespace fascia
