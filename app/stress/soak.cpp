#include "app/stress/soak.h"

#include <cmath>

#include "app/system/process_memory.h"
#include "sim/bare_mesh/settled_model.h"
#include "sim/replay/replay.h"
#include "sim/simulation/divergence.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr long kPull = 60, kHold = 60,
               kPeriod = 600;   // steps: moving to the target, staying there, and a whole grab with the rest after it
constexpr int kDirections = 4;  // grabs per round
constexpr double kFarthestPull = 0.2;  // of the body's size

// The vertices farthest from the supports, together as stiff as tissue under a disc.
struct Patch {
  std::vector<std::uint32_t> vertices;
  double stiffness = 0, size = 0;

  explicit Patch(const Model& model) {
    const std::vector<char> held = model.held();
    Vector3d center = Vector3d::Zero();
    double count = 0;
    Eigen::AlignedBox3d box;
    for (std::size_t v = 0; v < held.size(); ++v) {
      box.extend(model.rest_positions[v]);
      if (!held[v]) continue;
      center += model.rest_positions[v];
      ++count;
    }
    center = count > 0 ? Vector3d(center / count) : Vector3d(box.min());
    size = box.diagonal().norm();
    std::size_t farthest = 0;
    const auto distance = [&](std::size_t a, const Vector3d& b) { return (model.rest_positions[a] - b).norm(); };
    for (std::size_t v = 0; v < held.size(); ++v)
      if (distance(v, center) > distance(farthest, center)) farthest = v;
    for (std::uint32_t v = 0; v < held.size(); ++v)
      if (!held[v] && distance(v, model.rest_positions[farthest]) < 0.08 * size) vertices.push_back(v);
    stiffness = 3 * model.materials.front().young_modulus * 0.04 * size / static_cast<double>(vertices.size());
  }

  GrabInput springs(const Vector3d& offset) const {
    GrabInput springs;
    for (const std::uint32_t v : vertices) springs.push_back({v, offset, stiffness});
    return springs;
  }
};

}  // namespace

SoakRun soak(Bench& bench, const Scene& scene, long steps) {
  const Vector3d directions[kDirections] = {{1, 0, 0}, {0, 1, 0.3}, {0, -0.2, 1}, {-0.6, 0.5, -0.6}};
  Simulation simulation(scene, bench.graphics.programs.get(), false);
  const Patch patch(simulation.model);
  SoakRun run;
  for (long step = 0; step < steps; ++step) {
    const long grab = step / kPeriod, within = step % kPeriod;
    if (within < kPull)
      simulation.set_grab(patch.springs(kFarthestPull * patch.size * static_cast<double>(within + 1) / kPull *
                                        directions[grab % kDirections]));
    if (within == kPull + kHold) {
      run.strained = std::max(run.strained, reference::measure(simulation.model, simulation.state()).elastic);
      simulation.set_grab({});
      bench.stop_if_interrupted();
    }
    simulation.step();
    if (simulation.diverged()) require_valid(simulation);
    if (within != kPeriod - 1 || grab % kDirections != kDirections - 1) continue;
    const reference::Measures rest = reference::measure(simulation.model, simulation.state());
    run.elastic_last = rest.elastic;
    run.kinetic_last = rest.kinetic;
    run.gpu_last = gl::allocated_bytes();
    run.memory_last = resident_bytes();
    if (grab != kDirections - 1) continue;
    run.elastic_first = run.elastic_last;
    run.gpu_first = run.gpu_last;
    run.memory_first = run.memory_last;
  }
  require_valid(simulation);
  run.hash = state_hash(simulation.state());
  return run;
}

std::vector<std::string> soak_failures(const SoakRun& first, const SoakRun& second) {
  constexpr double kDrift = 1e-3;            // of the energy that the grabs add
  constexpr std::size_t kGrowth = 4u << 20;  // [bytes] that an allocator may keep
  std::vector<std::string> failures;
  if (first.hash != second.hash) failures.push_back("two runs end in different states");
  for (const SoakRun* run : {&first, &second}) {
    if (!(std::abs(run->elastic_last - run->elastic_first) < kDrift * run->strained))
      failures.push_back("the elastic energy at rest drifts");
    if (!(run->kinetic_last < kDrift * run->strained)) failures.push_back("the body does not come to rest");
    if (run->gpu_last != run->gpu_first) failures.push_back("GPU memory grows");
    if (run->memory_last > run->memory_first + kGrowth) failures.push_back("memory grows");
  }
  return failures;
}

int soak_scenes(Bench& bench, const std::vector<std::filesystem::path>& inputs, long steps,
                const Discretization& discretization) {
  Table table;
  table.columns = {"scene",
                   "tets",
                   "elements",
                   "integrator",
                   "steps",
                   "run",
                   "hash",
                   "elastic_first_J",
                   "elastic_last_J",
                   "kinetic_last_J",
                   "elastic_grabbed_J",
                   "gpu_first_bytes",
                   "gpu_last_bytes",
                   "memory_first_bytes",
                   "memory_last_bytes",
                   "failures"};
  int failed = 0;
  for (const std::filesystem::path& input : inputs) {
    Scene scene = open_scene(input);
    scene.solver.integrator = discretization.integrator().value_or(scene.solver.integrator);
    for (Body& body : scene.bodies) body.elements = discretization.elements().value_or(body.elements);
    const std::string name = input.stem().string();
    const std::size_t tets = settled_model(scene).tets.size();
    const SoakRun runs[2] = {soak(bench, scene, steps), soak(bench, scene, steps)};
    std::string what;
    for (const std::string& failure : soak_failures(runs[0], runs[1])) what += (what.empty() ? "" : "; ") + failure;
    failed += !what.empty();
    for (int k = 0; k < 2; ++k) {
      const SoakRun& run = runs[k];
      table.rows.push_back({name, tets, name_of(scene.bodies[0].elements), name_of(scene.solver.integrator), steps,
                            k + 1, hash_text(run.hash), run.elastic_first, run.elastic_last, run.kinetic_last,
                            run.strained, run.gpu_first, run.gpu_last, run.memory_first, run.memory_last, what});
    }
    bench.write("soak", table);
    bench.say(name + ": " + (what.empty() ? "passed" : what));
  }
  return failed;
}

}  // namespace fascia
