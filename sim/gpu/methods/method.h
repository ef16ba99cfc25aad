// What a solver method is to the step: the passes that it records between the prediction and the velocity update.
#pragma once
#include <vector>

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

  /// Takes over other settings of the same method, if that needs no new one: true then.
  virtual bool goes_on_with(const MethodInputs&) { return false; }
  /// uint [vertex_count + 1], copies before each vertex, of methods that share a vertex's mass between copies; null for
  /// the others.
  virtual const gl::Buffer* copy_begin() const { return nullptr; }
  /// Whether the iterations start where inertia alone leads, x_n + h v_n, and not at the prediction, which gravity has
  /// moved too.
  virtual bool starts_without_gravity() const { return false; }
  /// vec4 [2 * tet_count], of methods whose multipliers are part of the state that an acceleration combines; null for
  /// the others.
  virtual const gl::Buffer* multiplier() const { return nullptr; }
  /// float [vertex_count] by which Anderson acceleration weighs changes of the vertices [kg].
  virtual const gl::Buffer& weight_of_vertices(const SimBuffers& buffers) const { return buffers.mass; }
  virtual bool accelerates_itself() const { return false; }     // Acceleration::anderson is part of its iterations
  virtual bool may_rest_in_regions() const { return false; }    // a step may go through a part of the tets only
  virtual const Coloring* coloring() const { return nullptr; }  // of the tets, of methods that sweep them by color
  /// Whether iterations descend the objective with its external energies; else these are projected as constraints after
  /// each.
  virtual bool descends() const { return false; }
  /// What is computed before every iteration, of methods that descend the step's objective; null for the others.
  virtual const StepGradient* gradient() const { return nullptr; }
  virtual Passes begin(const Recording&) const { return {}; }  // once a substep, after the prediction
  /// What changes slowly enough to serve for some iterations: before those that refreshes_before() names.
  virtual Passes refresh(const Recording&) const { return {}; }
  /// The first, and every eighth unless so few are left that they would save less than it costs.
  static bool refreshes_before(int iteration, int iterations) {
    constexpr int kInterval = 8, kLeastLeft = 4;
    return iteration == 0 || (iteration % kInterval == 0 && iterations - iteration >= kLeastLeft);
  }
  /// One iteration, external energies included. The first one of a substep finds no history.
  virtual Passes iteration(const Recording& recording, bool first) const = 0;
  virtual Passes end(const Recording&) const {
    return {};
  }  // after the last iteration of a substep, unless a stop rule ended them
  /// What the passes of an iteration may put off (deferred_tets.h). `fused`: whether passes are (gl/fused_pass.h).
  virtual Deferral most_deferred(const SimBuffers&, bool fused) const { return static_cast<void>(fused), Deferral{}; }
  /// Before passes are recorded, with what they will be recorded from.
  virtual void prepare(const Recording&) {}
  /// Before the first step of some that go through a part of the tets only.
  virtual void begin_partial() {}
  /// Materials, masses, gravity or h have other values; buffers and passes stay.
  virtual void values_changed(const Model&, const SolverSettings&) {}
  /// What external energies add to the body's stiffness.
  virtual void set_stiffness(const std::vector<VertexStiffness>&) {}
  /// Whether all is there that the first step needs; what takes long is computed beside what else is made.
  virtual bool ready() const { return true; }
  /// Waits until it is. Before any step, and before the two below tell of later results.
  virtual void complete() {}
  /// Uploads what was computed beside the frame, if it is ready, or, with `wait`, all of it when it is. Returns how
  /// many results.
  virtual int update(bool wait) { return static_cast<void>(wait), 0; }
  /// Waits for so many results, if as many are computed, and uploads them.
  virtual void take(int results) { static_cast<void>(results); }
};

}  // namespace fascia
