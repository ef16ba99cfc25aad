// The GPU solver: owns the state and runs recorded lists of passes. A method adds its passes between prediction and
// velocity update; the lists contain only what the scene uses. Needs a current context with gl loaded.
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
#include "sim/gpu/acceleration/acceleration.h"
#include "sim/gpu/acceleration/stop_rule.h"
#include "sim/gpu/contact/contact_term.h"
#include "sim/gpu/contact/tool_watch.h"
#include "sim/gpu/integrators/stage.h"
#include "sim/gpu/methods/method.h"
#include "sim/gpu/passes/motion_targets.h"
#include "sim/gpu/passes/timed_passes.h"
#include "sim/gpu/readback/diagnostics.h"
#include "sim/gpu/readback/state_guard.h"
#include "sim/gpu/readback/step_snapshot.h"
#include "sim/gpu/readback/surface_positions.h"
#include "sim/gpu/readback/tangle_watch.h"
#include "sim/gpu/resting_regions.h"
#include "sim/model/unconstrained_parts.h"

namespace fascia {

class GpuSolver {
 public:
  /// `model` must outlive the solver. Its materials and gravity may be changed; call materials_changed() afterwards.
  /// `drawn` are extra vertices to draw, embedded in the tets (Model::embedded); none by default.
  GpuSolver(gl::ProgramCache& programs, const Model& model, const SolverSettings& settings,
            const EmbeddedPoints& drawn = {}, const Progress& progress = {});

  /// One frame step of settings.time_step: substeps and their stages, each of predict, iterations, velocity.
  void step();
  /// A step with separately timed passes, by the names of their kernels.
  std::map<std::string, KernelTime> timed_step();
  void reset();                          // to the initial state
  double time() const { return time_; }  // [s]

  const SolverSettings& settings() const { return settings_; }
  void set_settings(const SolverSettings& settings);
  void materials_changed();  // also for gravity; acts on the next step; no state buffer is rebuilt
  void set_grab(const std::vector<GrabSpring>& springs);  // empty: releases all grabs
  /// The motion of the tools in the next steps; none: on their paths.
  void set_tools(std::optional<ToolMotion> motion) { led_motion_ = std::move(motion); }
  /// The motion of the tools in the last stage.
  const ToolMotion& tool_motion() const { return stage_motion_; }
  /// [vertex] forces of the tools on the tissue at the end of the last step [N], zero in a state that was set; waits
  /// for the GPU.
  std::vector<Eigen::Vector3d> contact_forces() const { return contact_.forces_at_vertices(); }
  /// [ms] that the CPU has looked for tissue that touches tissue, in all steps so far.
  double pair_search_ms() const { return contact_.search_ms(); }
  long taken_back() const { return contact_.taken_back(); }
  void set_color(ColorBy color);
  ColorBy color() const { return color_; }
  /// The values of the heat maps of ColorBy::error [m] and mesh_error: float [vertex_count]. Zero at first.
  void set_vertex_errors(const std::vector<float>& errors);

  /// Updates positions() to the state, once per state.
  void publish();
  ShownRange* shown_range() { return surface_.range(); }  // of the heat map; null without one
  /// Whether the method descends the objective of the step, so that a body comes to rest at its static equilibrium.
  bool descends() const { return method_->gradient() != nullptr; }
  const gl::Buffer& positions() const { return surface_.positions(); }  // vec4 [vertex_count + points]

  /// One substep with diagnostics of the state before the first and after every iteration of its last stage:
  /// [iterations + 1]. For plots
  /// of convergence; waits for the GPU each time.
  std::vector<Diagnostics> traced_substep();

  void request_diagnostics();
  void set_probe(std::optional<std::uint32_t> vertex);        // Diagnostics::probe; below vertex_count
  bool diagnosing() const { return diagnostics_.pending(); }  // a request whose result was not taken yet
  std::optional<Diagnostics> take_diagnostics(bool wait) { return diagnostics_.take(wait); }

  /// Requests a check of the current state, and takes the result when it is available. Valid states are kept to go back
  /// to.
  void request_check();
  std::optional<StateGuard::Verdict> take_check(bool wait);
  /// The same at once, for a state that is not kept: waits for the GPU and does not affect later steps.
  std::optional<std::uint32_t> diverged_now() const;
  /// Sets the state at rest `equilibrium` and its time, inside a solved step, so that its diagnostics are those of a
  /// step.
  void settle(const State& equilibrium);
  /// A step in which nothing moves: the state, which was just found valid, stays unchanged.
  void rest();
  /// Restores the last state that was found valid or was set. With `at_rest`, without its velocities.
  void restore_valid(bool at_rest);

  /// Whether the buffers hold a complete substep, solved under the current model, settings and springs.
  bool has_step() const { return has_step_; }
  const IntegratorStage& stage() const { return stage_; }  // the last one of that substep
  const std::vector<GrabSpring>& springs() const { return springs_; }
  /// The number of steps that were solved, without those at rest. A changed number means a changed state.
  long steps_solved() const { return steps_solved_; }
  /// The share of the work that a step did, on average: less than 1 where regions rested (resting_regions.h).
  double share_solved() const;
  /// Whether the last step solved all tets.
  bool last_was_whole() const { return !is_partial(); }
  /// Whether the last step had contact: not where tools are far from tissue.
  bool last_had_contact() const { return touches(); }
  void solve_everything();  // in every later step
  /// Runs the kernels of a step in which some regions rest while others move, if there may be such steps, without any
  /// that move: the state stays. For filling a driver's cache.
  void run_partial_kernels();
  /// Steps once more, with contact if the last step had none and the other way round. For filling a driver's cache.
  void run_contact_kernels();

  State download() const;
  State download_valid() const { return guard_.download(buffers_); }  // the state of restore_valid()
  void upload(const State& state);
  /// Stores displacements in two floats each, for static equilibria: methods that descend the energy then accumulate
  /// what float32 would lose.
  void set_compensated(bool compensated);
  /// The mean over all stages so far: below settings().iterations where solver.tolerance ends them, and then waits
  /// for the GPU.
  double mean_iterations() const;
  int last_iterations() const;  // of the last stage; waits as mean_iterations() does
  /// Copies state, materials, gravity and grab from another solver of the same model; the state does not pass through
  /// the CPU.
  void follow(const GpuSolver& leader);
  /// Records all passes again: after ProgramCache::set_fusing(). The steps that follow make the same bits.
  void record_again() { record(); }
  /// Whether a step can begin without waiting for the method's setup or for kernels that the driver still links.
  bool ready() const;
  /// Waits for background computations (the coarse level's inverse after a change of materials or h) and takes their
  /// results.
  void finish_background() { background_taken_ += method_->update(true); }
  /// The first step after a background result is ready takes the result, which depends on timing. While held, results
  /// wait for take_background().
  void hold_background(bool held) { background_held_ = held; }
  void take_background(int results) { method_->take(results); }
  /// The number of results that steps have taken on their own since the last call.
  int background_taken() { return std::exchange(background_taken_, 0); }
  const Coloring* coloring() const { return method_->coloring(); }  // of gauss_seidel; null for other methods

  std::uint64_t dispatches_per_step() const;  // of a step like the last one, of all tets
  /// An estimate: every buffer that a kernel uses, once; passes of each iteration and their share of the refreshes,
  /// without deferred tets.
  double bytes_per_iteration() const;
  const SimBuffers& buffers() const { return buffers_; }

 private:
  GpuSolver(gl::ProgramCache& programs, const Model& model, const SolverSettings& settings, const EmbeddedPoints& drawn,
            const Progress& progress, MeshOrder placement);
  void make_method();  // creates only the parts that the solver choice needs
  void record();
  void run(const Passes& passes);
  void look_beside();
  std::vector<IntegratorStage> next_stages() const;  // of the next substep
  void upload_step(const IntegratorStage& stage);
  void begin_stage(const IntegratorStage& stage);
  void place_tools(const IntegratorStage& stage);
  void begin_step();                           // of time_step
  ToolMotion next_tools() const;               // in the next one
  bool takes_contact(int iteration) const;     // before it, into the coarse level
  void iterate(int iteration, int count = 1);  // `count` iterations, if fused and alike_from() permits
  void end_iterations();
  void move_bodies();
  void begin_again(bool stiff);
  void end_stage();
  void iterate_all();
  void solve_stage(const IntegratorStage& stage);
  void solve_substep();
  int alike_from(int iteration) const;  // the first later iteration that runs other passes
  void settings_changed();
  struct StepPasses {
    // Of one substep. `relist`: for pairs that the same stage did not have before; `again`: for iterations of the same
    // stage from displacements that have changed otherwise, or from where the last ones ended; `completion`:
    // after an iteration whose state something looks at; `check`: after the last one, where tissue may touch tissue
    Passes begin, relist, again, before_first, before, refresh, first_iteration, iteration, completion, check, end,
        renew;
    std::array<const Passes*, 9> lists() const {
      return {&begin, &before_first, &before, &refresh, &first_iteration, &iteration, &check, &end, &renew};
    }
    bool recorded() const { return !begin.empty(); }
  };
  // The same in few dispatches, where passes can be fused. `first`: the first iteration with the passes before it.
  struct FusedStep {
    gl::FusedPasses begin, relist, again, first, refresh, iteration, check, end, renew;
  };
  // A kind of steps, recorded when it is first needed.
  struct StepKind {
    StepPasses passes;
    std::optional<FusedStep> fused;
  };
  bool touches() const { return contact_.acts() && (kind_ == &whole_ || kind_ == &partial_); }
  bool is_partial() const { return kind_ == &partial_ || kind_ == &partial_apart_; }
  bool is_near();             // whether the next step needs contact
  void take(StepKind& kind);  // for the next steps
  void record(StepKind& kind);
  const StepKind& whole_kind() const { return contact_.acts() && !touches() ? apart_ : whole_; }
  void run(const Passes& passes, gl::FusedPasses FusedStep::*fused);  // in few dispatches where they are fused
  const FusedStep* fused_step() const;                                // of kind_; null where its passes run unfused
  std::optional<FusedStep> fuse(const StepPasses& passes);
  Start start();
  Recording recording(const ActiveSet* active, bool contact);
  StepPasses record_step(const ActiveSet* active, bool contact);
  bool may_relax() const;
  int refreshes() const;  // per substep
  bool renews(int iteration) const { return relaxes_ && StepMethod::renews_before(iteration, settings_.iterations); }
  Passes iteration(const Recording& recording, bool first);
  void choose_passes();
  void unfold();  // before a step (sim/gpu/unfolding.h)
  void end_unfolding();
  bool handled() const;                  // whether a grab, a tool or a prescribed motion acts
  void set_hardness(Hardness hardness);  // of the law squared (sim/gpu/readback/tangle_watch.h)
  void state_changed();
  void restart_rounds();                               // of what looks at the state every few steps
  std::uint32_t vertex_at(std::uint32_t place) const;  // `place`: as read back

  gl::ProgramCache& programs_;
  const Model& given_;
  Model model_;  // given_ in the order of placed(), which all members below use; materials and gravity follow
  SolverSettings settings_;
  UnconstrainedParts parts_;
  Features features_;
  ColorBy color_ = ColorBy::none;
  SimBuffers buffers_;
  gl::Buffer previous_strain_;  // vec4 [2 * linear_count + 8 * quadratic_count]; created when a material is first
                                // damped
  gl::Buffer unconstrained_;    // uint [vertex_count] 1 in unconstrained components; exists if other components are
                                // constrained and the method needs it
  std::unique_ptr<StepMethod> method_;
  Method made_ = Method::two_level;  // the method of method_
  std::unique_ptr<StepAcceleration> acceleration_;
  gl::Buffer multiplier_weight_;  // float [2 * tet_count], with Anderson acceleration of multipliers
  std::optional<StopRule> stop_;  // with solver.tolerance
  MotionTargets motions_;
  std::vector<GrabSpring> springs_;  // at vertices of given_
  GrabSprings grab_;
  ContactTerm contact_;
  BodyMotions bodies_;
  const EnergyTerms terms_{&grab_, &contact_};  // external energies
  const EnergyTerms terms_apart_{&grab_};       // those of steps in which no tool is near
  std::optional<ToolWatch> watch_;              // where there are tools, and tissue does not touch tissue
  std::optional<bool> near_;                    // run_contact_kernels(): regardless of watch_
  ToolMotion step_motion_, stage_motion_;       // of the last step, of its last stage
  std::optional<ToolMotion> led_motion_;        // none: on their paths
  double step_begin_ = 0;                       // [s]
  DiagnosticsReader diagnostics_;
  StateGuard guard_;
  bool published_ = false;  // positions() are those of the state
  SurfacePositions surface_;
  std::optional<DeferredTets> deferred_;   // with materials that defer tets
  std::optional<RestingRegions> regions_;  // where some regions may rest while others move
  // For all tets, with contact and without; for the tets of a step with resting regions, the same
  StepKind whole_, apart_, partial_, partial_apart_;
  double tools_way_ = 0;  // [m] of the tools since regions were listed, at most
  StepKind* kind_ = &whole_;
  gl::Downloads downloads_;  // for takes of contact
  bool always_whole_ = false;
  bool relaxes_ = false;  // a large K of quadratic tets, as recorded
  bool fuses_ = false;
  int before_every_ = 1;          // iterations from one run of `before` to the next
  TimedPasses* timed_ = nullptr;  // during a timed step
  bool background_held_ = false;
  int background_taken_ = 0;
  double time_ = 0;
  double earlier_step_ = 0;   // State::Earlier::step
  IntegratorStage stage_{0};  // whose values the kernels read
  long steps_solved_ = 0;
  std::uint64_t work_done_ = 0;      // SimBuffers::work() of all steps
  std::uint64_t stages_solved_ = 0;  // since stop_ was created
  bool starts_inside_out_ = false;   // until the first step
  struct Unfolding {
    double until;  // [s] the time at which it ends at the latest
    int steps = 0;
  };
  std::optional<Unfolding> unfolding_;
  std::optional<TangleWatch> tangles_;  // with the law squared
  bool has_step_ = false;
  unsigned materials_version_ = 0;  // changes of materials and gravity so far
};

}  // namespace fascia
