// The interface of a solver method: the passes that it records between the prediction and the velocity update.
#pragma once
#include <vector>

#include "gl/downloads.h"
#include "sim/coarse/coarse_contact.h"
#include "sim/gpu/passes/recording.h"
#include "sim/ordering/graph_coloring.h"

namespace fascia {

class StepGradient;
struct MethodInputs;

class StepMethod {
 public:
  StepMethod() = default;
  virtual ~StepMethod() = default;
  StepMethod(const StepMethod&) = delete;
  StepMethod& operator=(const StepMethod&) = delete;

  /// Takes over other settings of the same method. False where they need a new object.
  virtual bool goes_on_with(const MethodInputs&) { return false; }
  /// uint [vertex_count + 1], the number of copies before each vertex, for methods that share a vertex's mass between
  /// copies; null for the others.
  virtual const gl::Buffer* copy_begin() const { return nullptr; }
  /// Whether the iterations start at the inertial position x_n + h v_n instead of the prediction, which includes
  /// gravity.
  virtual bool starts_without_gravity() const { return false; }
  /// vec4 [2 * tet_count], for methods whose multipliers are part of the state that an acceleration combines; null for
  /// the others.
  virtual const gl::Buffer* multiplier() const { return nullptr; }
  /// float [vertex_count]: weights of the vertices' changes in Anderson acceleration [kg].
  virtual const gl::Buffer& weight_of_vertices(const SimBuffers& buffers) const { return buffers.mass; }
  virtual bool accelerates_itself() const { return false; }     // Acceleration::anderson is part of its iterations
  virtual bool may_rest_in_regions() const { return false; }    // a step may process only some of the tets
  virtual const Coloring* coloring() const { return nullptr; }  // of the tets, for methods that sweep them by color
  /// Whether iterations descend the objective with its external energies; otherwise these are projected as constraints
  /// after each iteration.
  virtual bool descends() const { return false; }
  /// The gradient that methods that descend the step's objective compute before every iteration; null for the others.
  virtual const StepGradient* gradient() const { return nullptr; }
  virtual Passes begin(const Recording&) const { return {}; }  // once per substep, after the prediction
  /// Before every iteration, and before those of refresh().
  virtual Passes before(const Recording&, bool first) const { return static_cast<void>(first), Passes{}; }
  /// Recomputes data that changes slowly enough to be reused for some iterations; runs before those of
  /// refreshes_before().
  virtual Passes refresh(const Recording&) const { return {}; }
  /// The first iteration and every eighth, unless so few remain that a refresh would cost more than it saves.
  static bool refreshes_before(int iteration, int iterations) {
    constexpr int kInterval = 8, kLeastLeft = 4;
    return iteration == 0 || (iteration % kInterval == 0 && iterations - iteration >= kLeastLeft);
  }
  /// Whether a large K of quadratic tets is relaxed in what is recorded from now on.
  virtual void relax(const Model&, bool) {}
  /// Instead of an iteration and what is before it, where renews_before(): with new multipliers of a relaxed K.
  virtual Passes renew(const Recording&) const { return {}; }
  static bool renews_before(int iteration, int iterations) {
    constexpr int kInterval = 4, kLeastLeft = 2;
    return iteration > 0 && iteration % kInterval == 0 && iterations - iteration >= kLeastLeft;
  }
  /// One iteration, external energies included. The first one of a substep has no history.
  virtual Passes iteration(const Recording& recording, bool first) const = 0;
  virtual Passes end(const Recording&) const {
    return {};
  }  // after the last iteration of a substep, unless a stop rule ended them
  /// Between two iterations, for a look at the state: complete what before() or end() would. Empty where iterations
  /// leave nothing to them.
  virtual Passes complete_iteration(const Recording&) const { return {}; }
  /// Upper bounds on what the passes of an iteration may defer (deferred_tets.h). `fused`: whether the passes are fused
  /// (gl/fused_pass.h).
  virtual Deferral most_deferred(const SimBuffers&, bool fused) const { return static_cast<void>(fused), Deferral{}; }
  /// What set_contact() needs of the GPU, read before each call.
  virtual void read_for_contact(gl::Downloads&) {}
  /// Takes the stiffness of contact, after begin() and again where it has changed.
  virtual void set_contact(const std::vector<PointStiffness>&) {}
  /// The next set_contact() depends on its argument alone, so that steps from this state on repeat to the bit.
  virtual void forget_contact() {}
  /// Called before passes are recorded, with their recording.
  virtual void prepare(const Recording&) {}
  /// Called before the first of a series of steps that process only some of the tets.
  virtual void begin_partial() {}
  /// Materials, masses, gravity or h have new values; buffers and passes stay valid.
  virtual void values_changed(const Model&, const SolverSettings&) {}
  /// Sets the stiffness that external energies add to the body's.
  virtual void set_stiffness(const std::vector<VertexStiffness>&) {}
  /// Whether everything for the first step is available; long computations run in parallel with the rest of the setup.
  virtual bool ready() const { return true; }
  /// Waits for ready(). Called before any step, and before the two functions below report later results.
  virtual void complete() {}
  /// Uploads a finished background result or, with `wait`, waits for all of them. Returns the number of results.
  virtual int update(bool wait) { return static_cast<void>(wait), 0; }
  /// Waits for up to `results` background results and uploads them.
  virtual void take(int results) { static_cast<void>(results); }
};

}  // namespace fascia
