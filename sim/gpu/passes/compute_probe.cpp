#include "sim/gpu/passes/compute_probe.h"

#include <numeric>

#include "base/error.h"
#include "gl/compute_pass.h"
#include "sim/gpu/passes/probe_words.h"
#include "sim/mesh/mesh_generate.h"

namespace fascia {
namespace {

constexpr const char* kExpected = "expected a device that computes; --context osmesa takes the software renderer";

}  // namespace

void require_computing(gl::ProgramCache& programs) {
  const gl::Buffer filled("probe", kProbeRepeats * sizeof kProbeWords);
  const gl::ComputePass pass(
      programs.compute("common/fill.comp"), {{"filled", &filled}}, kProbeRepeats,
      {{"word_0", kProbeWords[0]}, {"word_1", kProbeWords[1]}, {"word_2", kProbeWords[2]}, {"word_3", kProbeWords[3]}});
  pass.run();
  gl::Buffer copied = gl::Buffer::staging("probe_copy", filled.bytes());
  copied.copy(filled, filled.bytes());
  for (const gl::Buffer* buffer : std::array<const gl::Buffer*, 2>{&filled, &copied}) {
    const auto words = buffer->read<std::uint32_t>();
    for (std::size_t k = 0; k < words.size(); ++k)
      if (words[k] != kProbeWords[k % kProbeWords.size()])
        throw Error(
            gl::device().renderer,
            buffer == &filled ? "a kernel that ran left nothing in its buffer" : "a copy of a buffer is not the buffer",
            kExpected);
  }
}

Model trial_model() {
  Model model;
  model.file_mesh = make_box(2, 2, 2, {0.1, 0.1, 0.1});
  const auto vertices = static_cast<std::uint32_t>(model.file_mesh.positions.size()),
             tets = static_cast<std::uint32_t>(model.file_mesh.tets.size());
  model.rest_positions = model.file_mesh.positions;
  model.tets = model.file_mesh.tets;
  model.tet_material.assign(tets, 0);
  model.tet_source.resize(tets);
  std::iota(model.tet_source.begin(), model.tet_source.end(), 0u);
  model.materials = {Material{}};
  model.material_names = {"trial"};
  model.initial_velocity.assign(vertices, Eigen::Vector3d::Zero());
  for (std::uint32_t v = 0; v < vertices; ++v)
    if (model.rest_positions[v].x() == 0) model.fixed.push_back(v);
  model.bodies = {{"trial", 0, vertices, 0, tets, 0, 1, {}}};
  return model;
}

void require_computed(const Model& model, const State& state) {
  const std::vector<char> held = model.held();
  const std::vector<double> mass = lumped_masses(model);
  bool free = false, finite = false, moved = false;
  for (std::size_t v = 0; v < held.size(); ++v) {
    if (held[v] || mass[v] <= 0) continue;
    free = true;
    const Eigen::Vector3d& u = state.displacement[v];
    finite |= u.allFinite();
    moved |= !(u.array() == 0).all();
  }
  if (free && !finite) throw Error(gl::device().renderer, "no vertex is finite after the first steps", kExpected);
  if (free && !moved) throw Error(gl::device().renderer, "no vertex has moved in the first steps", kExpected);
}

void require_measured(bool measured) {
  if (!measured) throw Error(gl::device().renderer, "a kernel of a step left nothing in its buffer", kExpected);
}

}  // namespace fascia
