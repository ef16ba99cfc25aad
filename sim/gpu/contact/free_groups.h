// Groups of bodies that press each other and that nothing else holds, which so keep their momentum
// (shaders/sim/contact/contact_momentum.comp). The kernel leaves out those that are near a tool.
#pragma once
#include <cstdint>
#include <vector>

#include "sim/coarse/coarse_matrix.h"
#include "sim/contact/pair_row.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

inline constexpr std::uint32_t kNoBody = ~0u;  // NO_BODY of shaders/sim/contact

class FreeGroups {
 public:
  FreeGroups() = default;
  FreeGroups(const Model& model, const SimBuffers& buffers);

  /// In a stage with these pairs of tissue, and springs at places of the buffers' vertices.
  void begin(const std::vector<PairRow>& pairs, const std::vector<VertexStiffness>& springs);
  /// More pairs, in the same stage.
  void join(const std::vector<PairRow>& pairs);

  std::uint32_t body_count() const { return static_cast<std::uint32_t>(held_.size()); }
  const gl::Buffer& groups() const { return groups_; }  // uint [body] first body of its group; kNoBody if held or alone

 private:
  std::vector<std::uint32_t> bodies_;  // [place of a vertex]
  std::vector<char> held_;             // [body] some of its vertices are
  std::vector<char> pulled_;           // [body] held, or a spring acts on it
  gl::Buffer groups_;
};

}  // namespace fascia
