// The simulation of an open scene, by the GPU solver or by the double-precision reference. Independent of drawing.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/interrupt.h"
#include "sim/contact/tissue/tissue_cover.h"
#include "sim/gpu/solver.h"
#include "sim/reference/newton.h"
#include "sim/replay/input_log.h"
#include "sim/scene/scene.h"
#include "sim/simulation/scene_edits.h"
#include "sim/simulation/settling.h"
#include "sim/simulation/static_equilibrium.h"

namespace fascia {

class Simulation {
 public:
  static constexpr int kCheckInterval = 8;  // steps between checks for diverged vertices

  /// `built`: build_model(scene). `programs` null: no GPU, which only the reference solver permits. Throws Error.
  Simulation(Scene scene, Model built, gl::ProgramCache* programs, bool use_reference, const Progress& progress = {});
  Simulation(Scene scene, gl::ProgramCache* programs, bool use_reference);
  /// Starts at the replay's initial state and repeats its inputs during the steps. Throws Error if they do not fit the
  /// scene.
  void play(Replay replay);
  /// Returns the grab and the sliders to the user. The state and the values are kept; reset() goes to the replay's
  /// start.
  void end_replay();
  /// Whether the simulation is between the replay's first and last step.
  bool replaying() const { return replay_ && steps_ - replay_begin_ < replay_->steps; }
  long replayed_steps() const { return steps_ - replay_begin_; }
  const std::optional<State>& start() const { return start_; }  // where reset() goes; none: the scene's rest state
  void set_start(std::optional<State> start) { start_ = std::move(start); }  // of the same mesh
  /// Receives everything that a replay of this simulation needs, in order and with steps_made(). None: no recording.
  using Listener = std::function<void(const Input&)>;
  void set_listener(Listener listener) { listener_ = std::move(listener); }

  Scene scene;  // as opened; materials and solver settings follow the changes made here
  Model model;

  /// Whether a step can begin without waiting for the setup of the scene or of another method.
  bool ready() const { return reference_ || gpu_->ready(); }
  void step();
  /// Applies the replay's inputs before the next step; step() also does so.
  void repeat_inputs();
  void reset();
  /// Continues from a state of the same mesh. Throws Error if it belongs to another mesh.
  void go_on_from(const State& state);
  /// Continues from the current state so that a replay starting with it gives the same bits, and returns the state:
  /// data that solvers carry from step to step is reset. Precondition: no grab.
  State go_on_as_replay();
  double time() const;
  double simulated() const { return simulated_; }  // [s] over all steps: continues where time() goes back
  /// Static equilibrium, by the reference solver to 1e-10 or by the GPU to 1e-5, or to solver.tolerance if given.
  /// Newton's method in double precision continues to 1e-10 if no tolerance is given and its factor is quickly
  /// computed, and also, unless the mesh is too large, if float32 cannot reach the requested tolerance. The report
  /// contains the residual reached. `news` is called after every step with the progress, and finally, with a Newton
  /// iteration, when Newton's method begins. `stop` ends the search unconverged; by default Ctrl-C does
  /// (base/interrupt.h). With motions, grabs and tools as they are at `until` [s], by default at their ends; a later
  /// search goes on from there.
  StaticReport solve_static(const std::function<void(const StaticReport&)>& news = {},
                            std::stop_token stop = interrupt_token(), std::optional<double> until = std::nullopt);

  void set_settings(const SolverSettings& settings);
  void set_material(std::size_t index, const Material& material);  // of model.materials
  /// Replaces the entries of "materials" of the scene's bodies [bodies]: regions get a material of their own, or the
  /// default again. Keeps the state, ends a replay, and takes as long as opening the scene. Throws Error, without
  /// changes, if an entry names no region.
  void set_material_entries(const std::vector<MaterialEntries>& entries);
  void set_gravity(const Eigen::Vector3d& gravity);
  /// Sets the springs of grabs that are not the scene's: the mouse's, or a replay's; empty: no grab.
  void set_grab(std::vector<GrabSpring> springs);
  /// A hand leads an instrument: at this place at the end of the next step, and off its path until the next reset.
  void lead(const LedTool& tool);
  std::vector<LedTool> led_tools() const { return led_.tools(); }
  std::vector<ToolPlace> tool_places() const;                                      // [tool of the model] now
  const std::vector<GrabSpring>& asked_springs() const { return other_springs_; }  // of the last set_grab()
  /// All current springs, those of the scene's grabs after the others.
  const std::vector<GrabSpring>& springs() const { return springs_; }
  /// Whether grabs or instruments of the scene will still begin, move or end, instruments moved in the last step, or a
  /// replay plays, whose inputs may wake what sleeps.
  bool awaits_inputs() const {
    return replaying() || tools_moved_ || time() < std::max(model.end_of_grabs(), model.end_of_tools());
  }

  /// A vertex that diverged: it is not finite or left the scene. The GPU is queried every few steps without waiting, so
  /// the result may be some steps old. None while a replay will restore an earlier state.
  std::optional<std::uint32_t> diverged() const { return diverged_ && led_back_later() ? std::nullopt : diverged_; }
  /// Throws Error if the state diverged from the start and a valid body in its place diverges too: then the device does
  /// not compute. Waits for the GPU.
  void require_device() const;
  std::optional<std::uint32_t> check_now();  // as diverged(), for the current state: waits for the GPU
  /// Returns to the last valid state, at rest; settings, materials and grab are unchanged. Not recorded before
  /// begin_anew().
  void back_to_valid();
  State valid_state() const { return valid_state_; }  // of the last back_to_valid(), with its velocities
  void begin_anew();
  State last_valid() const;                     // the last one known, with its velocities
  const InputLog& log() const { return log_; }  // since the last known valid state
  long steps_made() const { return steps_; }
  /// Whether steps only advance time, because nothing moves and nothing has changed since the body came to rest
  /// (solver.rest_speed).
  bool asleep() const { return asleep_; }
  long steps_asleep() const { return steps_asleep_; }  // among all steps
  const std::optional<Replay>& replay() const { return replay_; }
  bool repeating() const {
    return replay_ && next_input_ < replay_->inputs.size();
  }  // whether inputs of the replay remain

  /// The mean number per substep over all steps so far: below the setting where solver.tolerance or solver.frame_budget
  /// limit it.
  double mean_iterations() const;
  /// The iterations of the next step: below the setting where solver.frame_budget limits them.
  int iterations_granted() const { return gpu_ && !reference_ ? gpu_->settings().iterations : scene.solver.iterations; }

  State state() const;
  GpuSolver* gpu() { return gpu_.get(); }  // null without a GPU
  const GpuSolver* gpu() const { return gpu_.get(); }
  gl::ProgramCache* programs() { return programs_; }  // null without a GPU
  bool uses_reference() const { return reference_ != nullptr; }
  const reference::NewtonReport& newton_report() const { return newton_report_; }
  /// [tool of the model] of the reference solver in its last step; the GPU's are in its Diagnostics.
  const std::vector<ToolLoad>& newton_tool_loads() const { return reference_->tool_loads(); }
  const std::vector<PairLoad>& newton_pair_loads() const { return reference_->pair_loads(); }  // of tissue on tissue
  /// Stages of all steps so far whose result would have led tissue through tissue (PairSearch::taken_back()).
  long taken_back() const { return uses_reference() ? newton_taken_back_ : gpu_->taken_back(); }
  /// Forces of contact in a static equilibrium that was found for the GPU in double precision, until the next step:
  /// there, the GPU's own are those of a step from it, whose error is large beside the weight of stiff bodies.
  struct EquilibriumContact {
    ContactLoads loads;
    std::vector<Eigen::Vector3d> vertices;  // [vertex] of the tools on the tissue [N]
  };
  /// Puts them in the place of those of the state that was read back.
  void correct_contact(std::optional<Diagnostics>& of_gpu) const;
  /// [vertex] forces of the tools on the tissue at the end of the last step [N]; waits for the GPU.
  std::vector<Eigen::Vector3d> contact_forces() const;

 private:
  void make_step();
  void step_within_budget();
  void repeat(const Change& change);
  void require_fit(const Replay& replay) const;
  bool led_back_later() const;
  void tell(Change change) const { tell(steps_, std::move(change)); }
  void tell(long step, Change change) const;
  void tell_of_background(long step);
  void apply_grab(const std::vector<GrabSpring>& springs, Change change);
  void grant(int iterations);
  void go_back_to(bool rest);
  void look();
  void follow_check(bool wait);
  bool settle();
  void judge_device(const StateGuard::Verdict& first);
  void wake();
  ToolMotion tool_motion() const;  // in the next step
  bool tools_move() const;
  bool tools_disturb();
  void cover_tissue();
  void give_motion();  // of led tools, to the solver
  void pull(std::vector<GrabSpring> springs);
  void renew_reference();
  void leave_equilibrium();
  Tuning tuning() const;

  gl::ProgramCache* programs_;
  std::unique_ptr<GpuSolver> gpu_;
  std::optional<State>
      equilibrium_;  // of solve_static() on the GPU, with more digits than float32 holds; until the next step
  std::optional<EquilibriumContact> equilibrium_contact_;
  double ms_per_iteration_ = 0;  // of the GPU, a running mean over steps; 0: not measured
  std::unique_ptr<reference::NewtonSolver> reference_;
  State reference_state_;
  reference::NewtonReport newton_report_;
  long newton_taken_back_ = 0;

  long steps_ = 0;  // so far
  double simulated_ = 0;
  std::optional<Replay> replay_;
  std::size_t next_input_ = 0;  // in the replay
  long replay_begin_ = 0;       // steps before it
  Tuning replay_tuning_;        // before its first input
  std::optional<State> start_;  // where reset() goes; none: the scene's rest state
  GrabTrack held_;
  LedTools led_;
  std::optional<TissueCover> cover_;  // of the tissue as it came to rest, in scenes with tools
  Listener listener_;
  InputLog log_;
  State valid_state_;
  std::optional<std::uint32_t> diverged_;
  long checked_step_ = 0;  // the last requested check is of the state before this step
  RestWatch rest_;
  std::vector<GrabSpring> other_springs_, springs_;  // without and with those of the scene's grabs
  bool quiet_ = false, asleep_ = false, tools_moved_ = false;
  bool unproven_ = true;  // nothing has been read back since construction
  bool diverged_from_the_start_ = false;
  Settling settling_;
  double settles_after_ = 0;  // [s] at rest: increases after every search that ended far away
  long woken_step_ = 0;       // the last change was before this step
  long steps_asleep_ = 0;
};

}  // namespace fascia
