#include "sim/gpu/features.h"

#include <algorithm>

namespace fascia {

Features features_of(const Model& model) {
  return {model.materials.size() > 1,
          std::any_of(model.materials.begin(), model.materials.end(), [](const Material& m) { return m.damping > 0; })};
}

gl::Defines defines_of(const Features& features) {
  return {{"DAMPING", features.damping ? "1" : "0"}, {"MATERIAL_PER_TET", features.material_per_tet ? "1" : "0"}};
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

}  // namespace fascia
