// The GPU solver: owns the state and runs recorded lists of passes. A method adds its passes between prediction and
// velocity update; what a scene does not use is not in the lists. Needs a current context with gl loaded.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "gl/fused_pass.h"
#include "gl/stopwatch.h"
#include "sim/gpu/acceleration/anderson.h"
#include "sim/gpu/acceleration/chebyshev.h"
#include "sim/gpu/acceleration/stop_rule.h"
#include "sim/gpu/integrators/implicit_euler.h"
#include "sim/gpu/methods/method.h"
#include "sim/gpu/passes/motion_targets.h"
#include "sim/gpu/readback/diagnostics.h"
#include "sim/gpu/readback/state_guard.h"
#include "sim/gpu/readback/step_snapshot.h"
#include "sim/gpu/readback/surface_positions.h"
#include "sim/gpu/resting_regions.h"
#include "sim/model/unconstrained_parts.h"

namespace fascia {

class GpuSolver {
 public:
  /// `model` must outlive the solver. Its materials and gravity may be changed; tell the solver with
  /// materials_changed(). `drawn` are extra vertices to draw, tied to the tets (Model::embedded); none by default.
  GpuSolver(gl::ProgramCache& programs, const Model& model, const SolverSettings& settings,
            const EmbeddedPoints& drawn = {}, const Progress& progress = {});

  /// One frame step of settings.time_step: substeps, each of predict, iterations, velocity.
  void step();
  struct KernelTime {
    double ms = 0;  // of all runs
    int runs = 0;
  };
  /// A step whose passes are timed one by one: by the names of their kernels. What goes by between passes, uploads for
  /// one, counts as the next one's.
  std::map<std::string, KernelTime> timed_step();
  void reset();                          // to the initial state
  double time() const { return time_; }  // [s]

  const SolverSettings& settings() const { return settings_; }
  void set_settings(const SolverSettings& settings);
  void materials_changed();  // also gravity: acts on the next step; no state buffer is rebuilt
  void set_grab(const std::vector<GrabSpring>& springs);  // empty: let go
  void set_color(ColorBy color);
  ColorBy color() const { return color_; }
  /// What the heat map of ColorBy::error shows: float [vertex_count] [m]. Zero at first.
  void set_vertex_errors(const std::vector<float>& errors);

  /// Brings positions() up to date with the state, once for every state.
  void publish();
  ShownRange* shown_range() { return surface_.range(); }  // of the heat map; null without one
  /// Whether the method descends the objective of the step, so that a body comes to rest where its static equilibrium
  /// is.
  bool descends() const { return method_->gradient() != nullptr; }
  const gl::Buffer& positions() const { return surface_.positions(); }  // vec4 [vertex_count + points]

  /// One substep that diagnoses the state after every iteration, and before the first: [iterations + 1]. For plots of
  /// convergence: waits for the GPU each time.
  std::vector<Diagnostics> traced_substep();

  void request_diagnostics();
  void set_probe(std::optional<std::uint32_t> vertex);        // Diagnostics::probe; below vertex_count
  bool diagnosing() const { return diagnostics_.pending(); }  // a request was not taken yet
  std::optional<Diagnostics> take_diagnostics(bool wait) { return diagnostics_.take(wait); }

  /// Asks whether the state of now is sound, and takes the answer when it is there. Sound states are kept to go back
  /// to.
  void request_check();
  std::optional<StateGuard::Verdict> take_check(bool wait);
  /// The same at once, of a state that is not kept: waits for the GPU, and the steps that follow do not notice.
  std::optional<std::uint32_t> diverged_now() const;
  /// The state at rest `equilibrium`, with a step around it that has been solved, so that its diagnostics are those of
  /// a step. No time passes.
  void settle(const State& equilibrium);
  /// A step in which nothing moves: the state, which has just been found sound, stays as it is.
  void rest();
  /// To the last state that was found sound, or was put there. With `at_rest` without its velocities.
  void restore_valid(bool at_rest);

  /// Whether the buffers hold a substep from its start to its end, solved under the model, settings and springs of now.
  bool has_step() const { return has_step_; }
  const std::vector<GrabSpring>& springs() const { return springs_; }
  /// Steps that were solved, not rested: tells whether a state is another one.
  long steps_solved() const { return steps_solved_; }
  /// Of the tets, on average over the steps that were solved: less than 1 where regions rested (regions.h).
  double share_solved() const;
  /// Whether the last step solved all tets.
  bool last_was_whole() const { return passes_ == &whole_; }
  void solve_everything();  // from now on, in every step

  State download() const { return buffers_.download_state(time_); }
  State download_valid() const { return guard_.download(buffers_); }  // the state of restore_valid()
  void upload(const State& state);
  /// Displacements in two floats each, for static equilibria: methods that descend the energy then sum up what float32
  /// would lose.
  void set_compensated(bool compensated);
  /// Of the substeps so far, on average: fewer than settings().iterations where solver.tolerance ends them. Waits for
  /// the GPU then.
  double mean_iterations() const;
  int last_iterations() const;  // of the last substep; as mean_iterations()
  /// State, materials, gravity and grab of another solver of the same model; the state without a way through the CPU.
  void follow(const GpuSolver& leader);
  /// Whether a step can begin without waiting for what is still computed since the method was made, or for kernels that
  /// the driver still links.
  bool ready() const;
  /// Waits for what is computed beside the frame (the coarse level's inverse after a change of materials or h) and
  /// takes it.
  void finish_background() { background_taken_ += method_->update(true); }
  /// It is taken at the first step that finds it ready, which depends on the moment. Held back, it waits for
  /// take_background().
  void hold_background(bool held) { background_held_ = held; }
  void take_background(int results) { method_->take(results); }
  /// Results that were taken without being told, since the last call.
  int background_taken() { return std::exchange(background_taken_, 0); }
  const Coloring* coloring() const { return method_->coloring(); }  // of gauss_seidel; null for other methods
  const Chebyshev* chebyshev() const { return chebyshev_ ? &*chebyshev_ : nullptr; }

  std::uint64_t dispatches_per_step() const;
  /// Estimated: every buffer that a kernel uses, once; what belongs to each iteration, the refreshes shared out,
  /// deferred tets left out.
  double bytes_per_iteration() const;
  const SimBuffers& buffers() const { return buffers_; }

 private:
  GpuSolver(gl::ProgramCache& programs, const Model& model, const SolverSettings& settings, const EmbeddedPoints& drawn,
            const Progress& progress, MeshOrder placement);
  void make_method();  // what the pair needs, and nothing else
  void record();
  void run(const Passes& passes);
  void look_beside();
  void begin_substep();
  void iterate(int iteration, int count = 1);  // so many, if fused and alike_from() tells so
  void end_substep();
  void solve_substep();
  int alike_from(int iteration) const;  // the first of the iterations after it that does not do the same
  void settings_changed();
  struct StepPasses {
    Passes begin, before_first, before, refresh, first_iteration, iteration, end;  // of one substep
    std::array<const Passes*, 7> lists() const {
      return {&begin, &before_first, &before, &refresh, &first_iteration, &iteration, &end};
    }
  };
  // The same in few dispatches, where passes can be fused. `first`: the first iteration with what comes before it.
  struct FusedStep {
    gl::FusedPasses begin, first, refresh, iteration, end;
  };
  const FusedStep* fused_step() const;  // of passes_; null where they run by themselves
  std::optional<FusedStep> fuse(const StepPasses& passes);
  Start start();
  Recording recording(const ActiveSet* active);
  StepPasses record_step(const ActiveSet* active);
  int refreshes() const;  // in a substep
  Passes iteration(const Recording& recording, bool first);
  void choose_passes();
  void state_changed();
  std::uint32_t vertex_at(std::uint32_t place) const;  // place as it was read back

  gl::ProgramCache& programs_;
  const Model& given_;
  Model model_;  // given_ placed(), as all below sees it; materials and gravity follow
  SolverSettings settings_;
  UnconstrainedParts parts_;
  Features features_;
  ColorBy color_ = ColorBy::none;
  SimBuffers buffers_;
  gl::Buffer previous_strain_;  // vec4 [2 * tet_count]; made when a material is first damped
  gl::Buffer unconstrained_;    // uint [vertex_count] 1 in parts that nothing holds; made where others are held, if the
                                // method wants it
  std::unique_ptr<StepMethod> method_;
  Method made_ = Method::two_level;     // what method_ is
  std::optional<Chebyshev> chebyshev_;  // of these only what is in use exists
  std::optional<Anderson> anderson_;
  gl::Buffer multiplier_weight_;  // float [2 * tet_count], with Anderson acceleration of multipliers
  std::optional<StopRule> stop_;  // with solver.tolerance
  MotionTargets motions_;
  std::vector<GrabSpring> springs_;  // at vertices of given_
  GrabSprings grab_;
  const EnergyTerms terms_{&grab_};  // external energies
  DiagnosticsReader diagnostics_;
  StateGuard guard_;
  bool published_ = false;  // positions() are those of the state
  SurfacePositions surface_;
  std::optional<DeferredTets> deferred_;   // with materials that have such
  std::optional<RestingRegions> regions_;  // where some may rest while others move
  StepPasses whole_,
      partial_;  // for all tets; for those of a step in which regions rest, recorded when there first is one
  std::optional<FusedStep> whole_fused_, partial_fused_;
  const StepPasses* passes_ = &whole_;
  bool always_whole_ = false;
  bool fuses_ = false;
  int before_every_ = 1;            // iterations from one run of `before` to the next
  gl::Stopwatch* times_ = nullptr;  // of a timed step
  bool background_held_ = false;
  int background_taken_ = 0;
  double time_ = 0;
  long steps_solved_ = 0;
  std::uint64_t tets_stepped_ = 0;
  std::uint64_t substeps_ = 0;  // since stop_ was made
  bool has_step_ = false;
  unsigned materials_version_ = 0;  // changes of materials and gravity so far
};

}  // namespace fascia
