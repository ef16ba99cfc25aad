#include "app/kernel_rehearsal.h"

#include <algorithm>
#include <utility>

#include "sim/gpu/solver.h"
#include "sim/mesh_generate.h"

namespace fascia {
namespace {

constexpr int kCellsAcross = 3, kTetsOfLayer = 6 * kCellsAcross * kCellsAcross;
constexpr int kFew = 12;                // layers of a mesh whose regions do not rest
constexpr std::size_t kFewFree = 24;    // vertices: fewer have no coarse level (sim/coarse_space.h)

// Without going through them: this is asked every frame.
std::size_t free_vertices(const Model& model) {
  std::size_t held = model.fixed.size();
  for (const Motion& motion : model.motions) held += motion.vertices.size();
  return model.rest_positions.size() - std::min(held, model.rest_positions.size());
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
  use.rests = model.tets.size() >= Regions::kLeastTets;
  use.coarse = free_vertices(model) >= kFewFree;
  use.held = !model.fixed.empty();
  use.prescribed = !model.motions.empty();
  use.embedded = !model.embedded.points.empty();
  return use;
}

Model rehearsal_body(const KernelUse& use) {
  const int layers = !use.coarse ? 1 : use.rests ? static_cast<int>(Regions::kLeastTets) / kTetsOfLayer + 1 : kFew;
  const int across = use.coarse ? kCellsAcross : 1;
  const TetMesh bar = make_box(across, across, layers, Eigen::Vector3d(0.1 * across, 0.1 * across, 0.1 * layers));
  Model model;
  model.rest_positions = bar.positions;
  model.tets = bar.tets;
  model.gravity.setZero();
  // So soft that what happens at one end is not felt at the other for some steps: most regions stay at rest.
  Material soft;
  soft.young_modulus = 1e-2;
  soft.damping = use.features.damping ? 1e-3 : 0;
  for (const auto& [wanted, kind] : {std::pair(use.features.signed_st_venant_kirchhoff, MaterialModel::signed_st_venant_kirchhoff),
                                     std::pair(use.features.st_venant_kirchhoff, MaterialModel::st_venant_kirchhoff),
                                     std::pair(use.features.stable_neo_hookean, MaterialModel::stable_neo_hookean)}) {
    if (!wanted) continue;
    soft.model = kind;
    model.materials.push_back(soft);
  }
  if (use.features.material_per_tet && model.materials.size() == 1) model.materials.push_back(soft);
  model.material_names.assign(model.materials.size(), "rehearsed");
  for (std::size_t t = 0; t < model.tets.size(); ++t) model.tet_material.push_back(static_cast<std::uint32_t>(t % model.materials.size()));
  if (use.held) model.fixed = {0};
  if (use.prescribed) model.motions.push_back({.vertices = {1}, .targets = {model.rest_positions[1]}});
  model.initial_velocity.assign(model.rest_positions.size(), Eigen::Vector3d::Zero());
  model.initial_velocity.back() = {0.01, 0, 0};
  if (use.embedded) model.embedded = embed({model.rest_positions.back()}, model.rest_positions, model.tets);
  model.file_mesh = bar;
  return model;
}

void rehearse(gl::ProgramCache& programs, const KernelUse& use, const std::function<bool(Rehearsed)>& go_on) {
  const Model body = rehearsal_body(use);
  GpuSolver solver(programs, body, use.solver, body.embedded);
  Rehearsed done = Rehearsed::nothing;
  if (!go_on(done)) return;
  const std::vector<GrabSpring> hand{{static_cast<std::uint32_t>(body.rest_positions.size()) - 1, Eigen::Vector3d::Zero(), 1e-3}};
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
  solver.set_grab(hand);
  solver.step();
  look();
  if (!go_on(done = Rehearsed::hands)) return;
  constexpr int kUntilSomeRest = 3;  // steps since something changed
  for (const bool held : {true, false}) {
    solver.set_grab(held ? hand : std::vector<GrabSpring>());
    solver.reset();
    for (int i = 0; i < kUntilSomeRest && use.rests; ++i) {
      solver.step();
      if (!go_on(done)) return;
    }
  }
  go_on(Rehearsed::all);
}

}  // namespace fascia
