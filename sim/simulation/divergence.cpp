#include "sim/simulation/divergence.h"

#include <sstream>

#include "base/dated_name.h"
#include "base/error.h"
#include "sim/reference/elasticity.h"
#include "sim/scene/scene_carry.h"
#include "sim/simulation/scene_edits.h"
#include "sim/tool/shape_distance.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// The log as a replay that begins with the valid state.
Replay replay_of(Simulation& simulation, State start) {
  const InputLog& log = simulation.log();
  start.led = log.tuning().led;
  Replay replay{simulation.scene, std::move(start), log.inputs(), simulation.steps_made() - log.begin()};
  replay.scene.solver = log.tuning().solver;
  replay.scene.gravity = log.tuning().gravity;
  follow_materials(replay.scene, simulation.model, log.tuning().materials);
  for (Input& input : replay.inputs) input.step -= log.begin();
  replay.scene = self_contained_if_possible(std::move(replay.scene), simulation.model.files);
  if (!log.tuning().springs.empty()) replay.inputs.insert(replay.inputs.begin(), Input{0, log.tuning().springs});
  return replay;
}

// Repeats the steps of the log on a separate solver.
class Repetition {
 public:
  Repetition(gl::ProgramCache& programs, const Simulation& simulation, const Replay& replay)
      : replay_(replay), model_(simulation.model), tuning_(simulation.log().tuning()) {
    model_.materials = tuning_.materials;
    model_.gravity = tuning_.gravity;
    solver_ = std::make_unique<GpuSolver>(programs, model_, tuning_.solver);
    solver_->finish_background();
    solver_->upload(*replay.start);
    led_.restart(replay.start->led);
  }

  void step() {
    for (; next_ < replay_.inputs.size() && replay_.inputs[next_].step <= steps_; ++next_) {
      const Input& input = replay_.inputs[next_];
      tuning_.apply(input);
      model_.materials = tuning_.materials;
      model_.gravity = tuning_.gravity;
      // As Simulation does: applies only changes, since an unchanged value must not wake regions at rest.
      if (std::holds_alternative<SolverSettings>(input.change))
        solver_->set_settings(tuning_.solver);
      else if (std::holds_alternative<GrabInput>(input.change))
        pull();
      else if (const auto* led = std::get_if<InstrumentInput>(&input.change))
        led_.lead(*led);
      else
        solver_->materials_changed();
      solver_->finish_background();
    }
    pull();
    if (!led_.empty())
      solver_->set_tools(led_.motion(model_.tools, solver_->time(), solver_->time() + tuning_.solver.time_step));
    solver_->step();
    led_.arrive();
    ++steps_;
    if (steps_ % Simulation::kCheckInterval == 0) {  // the first of the steps also followed such a check
      solver_->request_check();
      solver_->take_check(true);
    }
  }
  const GpuSolver& solver() const { return *solver_; }
  std::vector<ToolPlace> tool_places() const { return led_.motion(model_.tools, solver_->time(), solver_->time()).to; }

 private:
  void pull() {
    const GrabInput springs = with_grabs(tuning_.springs, model_.grabs, solver_->time() + tuning_.solver.time_step);
    if (springs != solver_->springs()) solver_->set_grab(springs);
  }

  const Replay& replay_;
  Model model_;
  Tuning tuning_;
  LedTools led_;
  std::unique_ptr<GpuSolver> solver_;
  std::size_t next_ = 0;
  long steps_ = 0;
};

void measure_tet(const Model& model, const State& state, std::size_t t, double& strain, double& det_f) {
  const Tet& tet = model.tets[t];
  Corners rest, u;
  for (std::size_t a = 0; a < 4; ++a) {
    rest[a] = model.rest_positions[tet[a]];
    u[a] = state.displacement[tet[a]];
  }
  const LinearTet shape(rest);
  strain = reference::green_strain_matrix(shape, u).norm();
  det_f = shape.deformation_gradient(u).determinant();
}

// The tool in which the tet is deepest, or which is within the length of its edges.
std::string tool_at(const Model& model, const State& state, const std::vector<ToolPlace>& places, std::size_t tet) {
  const auto rest = [&](std::size_t a) -> const Vector3d& { return model.rest_positions[model.tets[tet][a]]; };
  double nearest = 0.5 * model.contact.thickness;
  for (std::size_t a = 1; a < 4; ++a) nearest = std::max(nearest, (rest(a) - rest(0)).norm());
  std::string name;
  for (std::size_t t = 0; t < places.size(); ++t)
    for (std::size_t piece = 0; piece < model.tools[t].piece_count(); ++piece)
      for (const std::uint32_t v : model.tets[tet]) {
        const RigidPose pose = model.tools[t].pose_of_piece(piece, places[t]);
        const Vector3d local = pose.to_local(model.rest_positions[v] + state.displacement[v]);
        const double distance = distance_to(model.tools[t].shape, local).distance;
        if (!(distance < nearest)) continue;
        nearest = distance;
        name = model.tools[t].name;
      }
  return name;
}

}  // namespace

std::string Divergence::text(const Model& model) const {
  const Tet& v = model.tets[tet];
  std::ostringstream out;
  out.precision(3);
  out << "tet " << model.tet_source[tet] << " (vertices " << v[0] << ' ' << v[1] << ' ' << v[2] << ' ' << v[3]
      << ", strain " << strain << ", J " << det_f << ") diverged at " << time << " s";
  if (!tool.empty()) out << " in contact with " << tool;
  return out.str();
}

Divergence find_divergence(Simulation& simulation, std::uint32_t lost) {
  Divergence divergence;
  simulation.back_to_valid();
  divergence.replay = replay_of(simulation, simulation.valid_state());
  gl::ProgramCache& programs = *simulation.programs();
  State before = *divergence.replay.start;
  std::vector<ToolPlace> places;
  divergence.time = simulation.time();
  const auto repeat = [&](long steps) {
    Repetition repetition(programs, simulation, divergence.replay);
    for (long i = 0; i < steps; ++i) repetition.step();
    return repetition.solver().download();
  };
  Repetition repetition(programs, simulation, divergence.replay);
  for (long step = 0; step < divergence.replay.steps && !divergence.found; ++step) {
    repetition.step();
    if (const auto diverged = repetition.solver().diverged_now()) {
      divergence.found = true;
      lost = *diverged;
      divergence.time = repetition.solver().time();
      divergence.replay.steps = step + 1;
      before = repeat(step);
      places = repetition.tool_places();
    }
  }
  double largest = -1;
  for (std::size_t t = 0; t < simulation.model.tets.size(); ++t) {
    const Tet& tet = simulation.model.tets[t];
    if (std::find(tet.begin(), tet.end(), lost) == tet.end()) continue;
    double strain = 0, det_f = 1;
    measure_tet(simulation.model, before, t, strain, det_f);
    if (!(strain > largest)) continue;
    largest = divergence.strain = strain;
    divergence.det_f = det_f;
    divergence.tet = static_cast<std::uint32_t>(t);
  }
  divergence.tool = tool_at(simulation.model, before, places, divergence.tet);
  simulation.begin_anew();
  return divergence;
}

std::filesystem::path keep_replay(const Replay& replay) {
  const std::filesystem::path path = dated_name(".fascia");
  try {
    write_replay(path, replay);
    return path;
  } catch (const Error&) {
    const std::filesystem::path elsewhere = std::filesystem::temp_directory_path() / path;
    write_replay(elsewhere, replay);
    return elsewhere;
  }
}

void require_valid(Simulation& simulation) {
  gl::require_context();
  const std::optional<std::uint32_t> lost = simulation.check_now();
  if (!lost) return;
  simulation.require_device();
  const bool cut = !simulation.diverged();
  const Divergence divergence = find_divergence(simulation, *lost);
  throw Error(
      simulation.scene.file.string(),
      divergence.text(simulation.model) + ", repeated by " + keep_replay(divergence.replay).string(),
      cut ? "expected more steps: the replay goes back to a valid state later"
          : "expected finite positions: more iterations or substeps, softer material or a smaller load may help");
}

}  // namespace fascia
