#include "app/kernel_rehearsal.h"

#include <algorithm>

#include "sim/gpu/solver.h"

namespace fascia {
namespace {

constexpr double kSpeed = 0.01;  // of the vertex that moves, in sizes a second

// A free vertex and what tets connect it with: few regions.
std::vector<std::uint32_t> patch_of(const Model& model) {
  const std::vector<char> held = model.held();
  const auto is_free = [&](std::uint32_t v) { return !held[v]; };
  for (auto tet = model.tets.rbegin(); tet != model.tets.rend(); ++tet) {
    const auto center = std::find_if(tet->begin(), tet->end(), is_free);
    if (center == tet->end()) continue;
    std::vector<std::uint32_t> patch{*center};
    for (const Tet& other : model.tets)
      if (std::find(other.begin(), other.end(), *center) != other.end())
        for (const std::uint32_t v : other)
          if (is_free(v) && std::find(patch.begin(), patch.end(), v) == patch.end()) patch.push_back(v);
    return patch;
  }
  return {};
}

}  // namespace

KernelUse kernel_use(const SolverSettings& settings, const Model& model) {
  KernelUse use;
  use.solver.method = settings.method;
  use.solver.acceleration = settings.acceleration;
  use.solver.colors = settings.colors;
  use.solver.window = settings.window;
  constexpr double kNeverReached = 1e-30;  // all iterations run
  use.solver.tolerance = settings.tolerance > 0 ? kNeverReached : 0;
  if (settings.rest_speed <= 0) use.solver.rest_speed = 0;
  use.features = features_of(model);
  use.vertices = model.rest_positions.size();
  use.tets = model.tets.size();
  use.materials = model.materials.size();
  use.fixed = model.fixed.size();
  for (const Motion& motion : model.motions) use.moved += motion.vertices.size();
  use.drawn = model.embedded.points.size();
  return use;
}

Model rehearsal_body(const Model& model) {
  Model body;
  body.rest_positions = model.rest_positions;
  body.tets = model.tets;
  body.tet_material = model.tet_material;
  body.materials = model.materials;
  body.material_names = model.material_names;
  body.fixed = model.fixed;
  body.bodies = model.bodies;
  body.embedded = model.embedded;
  body.gravity.setZero();
  constexpr double kSoft = 1e-2;  // [Pa]
  for (Material& material : body.materials) material.young_modulus = kSoft;
  for (const Motion& motion : model.motions) {
    Motion& held = body.motions.emplace_back();
    held.vertices = motion.vertices;
    for (const std::uint32_t v : motion.vertices) held.targets.push_back(model.rest_positions[v]);
  }
  body.initial_velocity.assign(body.rest_positions.size(), Eigen::Vector3d::Zero());
  return body;
}

void rehearse(gl::ProgramCache& programs, const KernelUse& use, const Model& body, const std::function<bool(Rehearsed)>& go_on) {
  GpuSolver solver(programs, body, use.solver, body.embedded);
  Rehearsed done = Rehearsed::nothing;
  if (!go_on(done)) return;
  const auto look = [&] {
    solver.request_diagnostics();
    solver.take_diagnostics(true);
    solver.publish();
  };
  solver.step();
  look();
  solver.request_check();
  solver.take_check(true);
  if (!go_on(done = Rehearsed::steps)) return;

  std::vector<GrabSpring> hand;
  for (const std::uint32_t v : patch_of(body)) hand.push_back({v, Eigen::Vector3d::Zero(), 1e-3});
  solver.set_grab(hand);
  solver.step();
  look();
  if (!go_on(done = Rehearsed::hands)) return;

  constexpr int kUntilSomeRest = 3;  // steps since something changed
  const bool may_rest = use.tets >= Regions::kLeastTets && !hand.empty();
  for (const bool held : {true, false}) {
    if (!may_rest) break;
    solver.set_grab(held ? hand : std::vector<GrabSpring>());
    reference::State state = reference::initial_state(body);
    state.velocity[hand.front().vertex] = {kSpeed * solver.buffers().size, 0, 0};
    solver.upload(state);
    for (int i = 0; i < kUntilSomeRest; ++i) {
      solver.step();
      if (!go_on(done)) return;
    }
  }
  go_on(Rehearsed::all);
}

}  // namespace fascia
