// Leaves regions of the tissue that are at rest out of most steps. Two of eight steps solve everything. A region that
// rests in both of them and has no moving neighbor stays at rest in the six that follow: its speed was below
// solver.rest_speed after both. Such a region is constrained at its current place, so that the step equals one with
// that region fixed; the next whole step makes up for the motion that was left out. Nothing is stored from one round to
// the next, so that steps from any state repeat to the bit.
#pragma once
#include <algorithm>
#include <functional>
#include <vector>

#include "gl/compute_pass.h"
#include "sim/gpu/passes/active_set.h"
#include "sim/gpu/passes/sim_buffers.h"

namespace fascia {

class RestingRegions {
 public:
  static constexpr std::uint32_t kLeastTets = 2000;  // smallest SimBuffers::work() for which regions pay

  /// `buffers` must outlive this object and keep the order of the tets.
  RestingRegions(gl::ProgramCache& programs, const SimBuffers& buffers);

  /// Prepares the next step. True: active() lists what the step solves; false: it solves everything. Once per round it
  /// waits for the GPU and asks for `awake`, the vertices around which regions are taken to move: they are being acted
  /// on.
  bool begin_step(const SolverSettings& settings, const std::function<std::vector<std::uint32_t>()>& awake);
  /// Says, within a step, that a tool presses at a vertex. If none did in the same region when regions were listed, a
  /// new round begins after the step: what is met anew may set more in motion than moves already.
  void press(std::uint32_t vertex);
  void end_step();
  /// Begins a new round, with whole steps: an input acts on the whole body, or the state was replaced or must be
  /// restorable.
  void restart() {
    phase_ = 0;
    std::fill(pressed_.begin(), pressed_.end(), 0);
  }

  const ActiveSet& active() const { return active_; }
  std::uint32_t region_count() const { return static_cast<std::uint32_t>(region_begin_.size() - 1); }

 private:
  static constexpr int kWholeSteps = 2, kRound = 8;
  bool list(const SolverSettings& settings, const std::vector<std::uint32_t>& awake);

  const SimBuffers& buffers_;
  std::vector<std::uint32_t> vertex_region_;                   // [vertex_count]
  std::vector<std::uint32_t> region_begin_, region_vertices_;  // vertices by region
  std::vector<std::vector<std::uint32_t>> neighbors_;          // [region_count]
  std::vector<char> pressed_;                                  // [region_count] since the round began
  std::vector<char> listed_;  // [region_count] 1 for regions in the current lists; empty: no lists
  ActiveSet active_;
  gl::Buffer begin_, vertices_, motion_, measured_;
  std::vector<gl::ComputePass> measure_;  // after the first step of a round, after the second
  int phase_ = 0;                         // steps since the round began
  bool partial_ = false, met_ = false;    // met_: a tool presses where none did
};

}  // namespace fascia
