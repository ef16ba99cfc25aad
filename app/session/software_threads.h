// Configures the worker threads of the software renderer llvmpipe: their number, and the cores on which they run.
#pragma once
#include <cstddef>
#include <vector>

#include "sim/model/model.h"
#include "sim/scene/scene.h"

namespace fascia {

/// The predominant work of a software renderer.
struct Workload {
  Method method = Method::jacobi;
  std::size_t tets = 0;
  bool drawn = true;
  bool fused = true;  // whether the passes of a step are fused (gl/fused_pass.h): not with solver.tolerance, except
                      // for --static
};
Workload workload_of(const Scene& scene, const Model& model, bool static_equilibrium, bool drawn = true);

/// Create it before a context, and call spread() afterwards for the threads of that context.
class SoftwareThreads {
 public:
  /// Sets the number of threads (LP_NUM_THREADS, unless the user set it); it cannot be changed later.
  explicit SoftwareThreads(const Workload& workload);

  /// Binds each thread that runs kernels to a core of its own, if there are as many cores as threads: otherwise Linux
  /// at times runs two of them on one core (docs/concepts/performance.md has the gain). No effect on other systems or
  /// without such threads.
  void spread() const;

 private:
  std::vector<int> before_;  // threads that existed before
};

}  // namespace fascia
