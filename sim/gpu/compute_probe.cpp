#include "sim/gpu/compute_probe.h"

#include <array>

#include "render/gl/compute_pass.h"
#include "sim/error.h"

namespace fascia {
namespace {

constexpr const char* kExpected = "expected a device that computes; --context osmesa takes the software renderer";

}  // namespace

void require_computing(gl::ProgramCache& programs) {
  constexpr std::array<std::uint32_t, 4> kWords{0x3f9d70a4, 0x00c0ffee, 0x5eed0001, 0xfffffff7};
  constexpr std::uint32_t kRepeats = 64;
  const gl::Buffer filled("probe", kRepeats * sizeof kWords);
  const gl::ComputePass pass(
      programs.compute("common/fill.comp"), {{"filled", &filled}}, kRepeats,
      {{"word_0", kWords[0]}, {"word_1", kWords[1]}, {"word_2", kWords[2]}, {"word_3", kWords[3]}});
  pass.run();
  gl::Buffer copied = gl::Buffer::staging("probe_copy", filled.bytes());
  copied.copy(filled, filled.bytes());
  for (const gl::Buffer* buffer : std::array<const gl::Buffer*, 2>{&filled, &copied}) {
    const auto words = buffer->read<std::uint32_t>();
    for (std::size_t k = 0; k < words.size(); ++k)
      if (words[k] != kWords[k % kWords.size()])
        throw Error(gl::device().renderer, buffer == &filled ? "a kernel that ran left nothing in its buffer" : "a copy of a buffer is not the buffer",
                    kExpected);
  }
}

void require_computed(const Model& model, const reference::State& state, bool must_move) {
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
  if (free && !moved && must_move) throw Error(gl::device().renderer, "no vertex has moved in the first steps", kExpected);
}

}  // namespace fascia
