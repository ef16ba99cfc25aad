// The worker threads of the software renderer llvmpipe: how many there are, and on which cores they run.
#pragma once
#include <cstddef>
#include <vector>

#include "sim/model/model.h"
#include "sim/scene/scene.h"

namespace fascia {

/// What a software renderer will mostly do.
struct Workload {
  Method method = Method::jacobi;
  std::size_t tets = 0;
  bool drawn = true;
  bool fused = true;  // whether the passes of a step are (gl/fused_pass.h): not with solver.tolerance, which --static
                      // has another way
};
Workload workload_of(const Scene& scene, const Model& model, bool static_equilibrium, bool drawn = true);

/// Made before a context, asked to spread what came with it afterwards.
class SoftwareThreads {
 public:
  /// Chooses how many there will be (LP_NUM_THREADS, if the user did not set it); it cannot be changed later.
  explicit SoftwareThreads(const Workload& workload);

  /// Gives each of the threads that run kernels a core of its own, where there are as many of both: left to itself
  /// Linux at times runs two of them on one (docs/concepts/performance.md has what it brings). Without a word where it
  /// is no Linux or there are no such threads.
  void spread() const;

 private:
  std::vector<int> before_;  // the threads that there were
};

}  // namespace fascia
