// An open scene being simulated, by the GPU solver or by the double-precision reference. Draws nothing.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/interrupt.h"
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
  static constexpr int kCheckInterval = 8;  // steps from one look for lost vertices to the next

  /// `built`: build_model(scene). `programs` null: no GPU at all, which only the reference solver can do without.
  /// Throws Error.
  Simulation(Scene scene, Model built, gl::ProgramCache* programs, bool use_reference, const Progress& progress = {});
  Simulation(Scene scene, gl::ProgramCache* programs, bool use_reference);
  /// Starts where the replay does and repeats its inputs as the steps go on. Throws Error if they do not fit the scene.
  void play(Replay replay);
  /// From now on the grab and the sliders are the user's again. The state stays, and so do the values; reset() goes
  /// where it started.
  void end_replay();
  /// Between its first and its last step.
  bool replaying() const { return replay_ && steps_ - replay_begin_ < replay_->steps; }
  long replayed_steps() const { return steps_ - replay_begin_; }
  const std::optional<State>& start() const { return start_; }               // where reset() goes; none: at rest
  void set_start(std::optional<State> start) { start_ = std::move(start); }  // of the same mesh
  /// Hears of all that a replay of this simulation needs, in the order in which it acts, by steps_made(). None: nobody
  /// listens.
  using Listener = std::function<void(const Input&)>;
  void set_listener(Listener listener) { listener_ = std::move(listener); }

  Scene scene;  // as opened; materials and solver settings follow the changes made here
  Model model;

  /// Whether a step can begin without waiting for what opening or another method still computes.
  bool ready() const { return reference_ || gpu_->ready(); }
  void step();
  /// What a replay has before the next step; step() does it by itself.
  void repeat_inputs();
  void reset();
  /// Goes on from a state of the same mesh. Throws Error if it is of another one.
  void go_on_from(const State& state);
  /// Goes on from the state of now to the bits of a replay that starts with it, and returns it: whatever solvers carry
  /// from step to step begins anew. Precondition: nothing is held.
  State go_on_as_replay();
  double time() const;
  double simulated() const { return simulated_; }  // in all steps made [s]: goes on where time() goes back
  /// Static equilibrium, by the reference solver to 1e-10 or by the GPU to 1e-5, or to solver.tolerance if that is
  /// given. Newton's method in double precision goes on from there to 1e-10 where no tolerance is given and its factor
  /// is soon made, and, with meshes that are not too large for it, where float32 does not go so far as was asked. The
  /// report tells how far it got. `news`: hears of every step how far it is, and at last, with a Newton iteration, when
  /// Newton's method begins. `stop` ends it unconverged; by itself Ctrl-C does (base/interrupt.h).
  StaticReport solve_static(const std::function<void(const StaticReport&)>& news = {},
                            std::stop_token stop = interrupt_token());

  void set_settings(const SolverSettings& settings);
  void set_material(std::size_t index, const Material& material);  // of model.materials
  /// Other entries of "materials" for the scene's bodies [bodies]: regions get a material of their own, or the default
  /// again. Keeps the state, ends a replay, and takes as long as opening does. Throws Error and changes nothing where
  /// an entry names no region.
  void set_material_entries(const std::vector<MaterialEntries>& entries);
  void set_gravity(const Eigen::Vector3d& gravity);
  /// The springs, from now on, of grabs beside those of the scene: the mouse's, or a replay's; empty: let go.
  void set_grab(std::vector<GrabSpring> springs);
  const std::vector<GrabSpring>& asked_springs() const { return other_springs_; }  // the last set_grab()
  /// All springs that pull now, those of the scene's grabs behind the others.
  const std::vector<GrabSpring>& springs() const { return springs_; }
  /// Whether grabs of the scene will still take hold, move or let go.
  bool awaits_grabs() const { return time() < model.end_of_grabs(); }

  /// A vertex that is no longer finite or has run away, as far as is known: the GPU is asked every few steps, and
  /// nothing waits. Not while a replay knows that it will be led back.
  std::optional<std::uint32_t> diverged() const { return diverged_ && led_back_later() ? std::nullopt : diverged_; }
  /// Throws Error where the state was lost from the start and a sound body in its place is lost, too: not tissue that
  /// breaks but a device that does not compute. Waits for the GPU.
  void require_device() const;
  std::optional<std::uint32_t> check_now();  // as diverged(), of the state of now: waits for the GPU
  /// The last sound state, at rest; settings, materials and grab stay as they are. Not recorded before begin_anew().
  void back_to_valid();
  State valid_state() const { return valid_state_; }  // of the last back_to_valid(), with its velocities
  void begin_anew();
  State last_valid() const { return gpu_->download_valid(); }  // as far as is known, with its velocities
  const InputLog& log() const { return log_; }                 // since the last state that is known to be sound
  long steps_made() const { return steps_; }
  /// Whether steps only let time pass, for nothing moves and nothing has changed since it came to rest
  /// (solver.rest_speed).
  bool asleep() const { return asleep_; }
  long steps_asleep() const { return steps_asleep_; }  // of those made
  const std::optional<Replay>& replay() const { return replay_; }
  bool repeating() const {
    return replay_ && next_input_ < replay_->inputs.size();
  }  // inputs of the replay are still to come

  /// Per substep, of all steps so far on average: fewer than asked for where solver.tolerance or solver.frame_budget
  /// bind.
  double mean_iterations() const;
  /// How many of the iterations the next step gets: fewer than asked for where solver.frame_budget binds.
  int iterations_granted() const { return gpu_ && !reference_ ? gpu_->settings().iterations : scene.solver.iterations; }

  State state() const;
  GpuSolver* gpu() { return gpu_.get(); }  // null without a GPU
  const GpuSolver* gpu() const { return gpu_.get(); }
  gl::ProgramCache* programs() { return programs_; }  // null without a GPU
  bool uses_reference() const { return reference_ != nullptr; }
  const reference::NewtonReport& newton_report() const { return newton_report_; }

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
  void pull(std::vector<GrabSpring> springs);
  void renew_reference();
  Tuning tuning() const;

  gl::ProgramCache* programs_;
  std::unique_ptr<GpuSolver> gpu_;
  std::optional<State>
      equilibrium_;              // of solve_static() on the GPU, to more digits than float32 holds; until the next step
  double ms_per_iteration_ = 0;  // of the GPU, a running mean over steps; 0: not measured
  std::unique_ptr<reference::NewtonSolver> reference_;
  State reference_state_;
  reference::NewtonReport newton_report_;

  long steps_ = 0;  // made
  double simulated_ = 0;
  std::optional<Replay> replay_;
  std::size_t next_input_ = 0;  // of the replay
  long replay_begin_ = 0;       // steps made before it
  Tuning replay_tuning_;        // before its first input
  std::optional<State> start_;  // where reset() goes; none: at rest
  GrabTrack held_;
  Listener listener_;
  InputLog log_;
  State valid_state_;
  std::optional<std::uint32_t> diverged_;
  long checked_step_ = 0;  // the state that was last asked about came before this step
  RestWatch rest_;
  std::vector<GrabSpring> other_springs_, springs_;  // without and with those of the scene's grabs
  bool quiet_ = false, asleep_ = false;
  bool unproven_ = true;  // nothing has been read back since this was made
  bool diverged_from_the_start_ = false;
  Settling settling_;
  double settles_after_ = 0;  // [s] at rest: longer after every search that ended far away
  long woken_step_ = 0;       // the last change came before this step
  long steps_asleep_ = 0;
};

}  // namespace fascia
