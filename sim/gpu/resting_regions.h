// Regions of the tissue that are at rest are left out of most steps. Two of eight steps solve everything; what rests in
// both of them and has no moving region beside it goes on resting in the six that follow: its speed was below
// solver.rest_speed after both. A resting region is held where it is, so that a step is what it would be if that region
// were fixed; what it would have done in the meantime it does in the next whole step. Nothing is remembered from one
// round to the next, so that steps from any state repeat to the bit.
#pragma once
#include <vector>

#include "gl/compute_pass.h"
#include "sim/coarse/coarse_matrix.h"
#include "sim/gpu/passes/active_set.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

class RestingRegions {
 public:
  static constexpr std::uint32_t kLeastTets = 2000;  // of a mesh that is worth it

  /// `buffers` must outlive this, with the tets in the order they have now.
  RestingRegions(gl::ProgramCache& programs, const SimBuffers& buffers);

  /// Decides about the next step. True: active() holds what it solves; false: it solves everything. Waits for the GPU
  /// once in a round.
  bool begin_step(const SolverSettings& settings, const std::vector<VertexStiffness>& springs);
  void end_step();
  /// Something acts on all of it, or the state is another one or one to go back to: a round begins, with whole steps.
  void restart() { phase_ = 0; }

  const ActiveSet& active() const { return active_; }
  std::uint32_t region_count() const { return static_cast<std::uint32_t>(region_begin_.size() - 1); }

 private:
  static constexpr int kWholeSteps = 2, kRound = 8;
  bool list(const SolverSettings& settings, const std::vector<VertexStiffness>& springs);

  const SimBuffers& buffers_;
  std::vector<std::uint32_t> vertex_region_;                   // [vertex_count]
  std::vector<std::uint32_t> region_begin_, region_vertices_;  // vertices by region
  std::vector<std::vector<std::uint32_t>> neighbors_;          // [region_count]
  std::vector<char> listed_;  // [region_count] moving when the lists were made; empty: there are none
  ActiveSet active_;
  gl::Buffer begin_, vertices_, motion_, measured_;
  std::vector<gl::ComputePass> measure_;  // after the first step of a round, after the second
  int phase_ = 0;                         // steps since the round began
  bool partial_ = false;
};

}  // namespace fascia
