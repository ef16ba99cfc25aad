#include "sim/gpu/passes/features.h"

#include <algorithm>

namespace fascia {

Features features_of(const Model& model) {
  const auto any = [&](auto&& has) { return std::any_of(model.materials.begin(), model.materials.end(), has); };
  const auto any_of_model = [&](MaterialModel wanted) { return any([=](const Material& m) { return m.model == wanted; }); };
  return {model.materials.size() > 1, any([](const Material& m) { return m.damping > 0; }),
          any_of_model(MaterialModel::signed_st_venant_kirchhoff), any_of_model(MaterialModel::st_venant_kirchhoff),
          any_of_model(MaterialModel::stable_neo_hookean)};
}

gl::Defines defines_of(const Features& features) {
  const auto flag = [](bool on) { return on ? "1" : "0"; };
  return {{"DAMPING", flag(features.damping)},
          {"MATERIAL_PER_TET", flag(features.material_per_tet)},
          {"SIGNED_ST_VENANT_KIRCHHOFF", flag(features.signed_st_venant_kirchhoff)},
          {"ST_VENANT_KIRCHHOFF", flag(features.st_venant_kirchhoff)},
          {"STABLE_NEO_HOOKEAN", flag(features.stable_neo_hookean)}};
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

gl::ComputePass::Bindings with_pairs(gl::ComputePass::Bindings bindings, const SimBuffers& buffers) {
  bindings.insert(bindings.end(),
                  {{"tet_vertices", &buffers.tet_vertices}, {"tet_shape", &buffers.tet_shape}, {"pair_fifth", &buffers.pair_fifth}});
  return bindings;
}

gl::ComputePass::Constants constants_of_pairs(const SimBuffers& buffers) {
  return {{"pair_count", buffers.pair_count}, {"second_begin", buffers.pair_and_single_count()}};
}

gl::ComputePass::Bindings with_slots(gl::ComputePass::Bindings bindings, const SimBuffers& buffers) {
  bindings.insert(bindings.end(), {{"pair_slots", &buffers.pair_slots}, {"correction", &buffers.correction}});
  return with_pairs(std::move(bindings), buffers);
}

}  // namespace fascia
