// Grabs of a simulation: springs by id, each a separate grab to the solver.
#include "api/simulation.h"
#include "api/values.h"

namespace fascia::api {
namespace {

// The default stiffness of the program's grabs (sim/grab/grab_patch.h) for a patch of the default size.
double usual_stiffness(const Model& model, const std::vector<PatchVertex>& patch) {
  return patch_stiffness(patch, kPatchRadius * scene_radius(model));
}

}  // namespace

Grab Simulation::Impl::take(const std::vector<PatchVertex>& patch, double stiffness) {
  if (patch.empty())
    throw Error("grab", "holds no free vertex", "expected at least one that is in a tet and neither fixed nor led");
  if (!(stiffness > 0 && std::isfinite(stiffness)))
    throw Error("grab: stiffness", "is not positive", "expected N/m, or 0 for the tissue's own");
  if (next_grab >= kFirstScriptedGrab)
    throw Error("grab", "too many were made", "expected at most " + std::to_string(kFirstScriptedGrab));
  const fascia::State state = simulation->state();
  Held grab{{}, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (const PatchVertex& p : patch) {
    grab.springs.push_back({p.vertex, state.displacement[p.vertex], p.share * stiffness, next_grab});
    grab.center += p.share * (simulation->model.rest_positions[p.vertex] + state.displacement[p.vertex]);
  }
  grab.target = grab.center;
  held.emplace(next_grab, std::move(grab));
  pull();
  return Grab(next_grab++);
}

Simulation::Impl::Held& Simulation::Impl::find(Grab grab) {
  const auto found = held.find(static_cast<std::uint32_t>(grab));
  if (found == held.end())
    throw Error("grab " + std::to_string(static_cast<std::uint32_t>(grab)), "does not exist",
                "expected one that was not released");
  return found->second;
}

void Simulation::Impl::pull() {
  std::vector<GrabSpring> springs;
  for (const auto& [name, grab] : held)
    for (GrabSpring spring : grab.springs) {
      spring.target += grab.target - grab.center;
      springs.push_back(spring);
    }
  simulation->set_grab(std::move(springs));
}

Grab Simulation::grab(std::span<const std::uint32_t> vertices, double stiffness) {
  for (const std::uint32_t v : vertices)
    if (v >= vertex_count())
      throw Error("grab", "names vertex " + std::to_string(v),
                  "expected an index below " + std::to_string(vertex_count()));
  return impl_->call([&](fascia::Simulation& simulation) {
    const std::vector<PatchVertex> patch = even_patch(simulation.model, {vertices.begin(), vertices.end()});
    return impl_->take(patch, stiffness == 0 && !patch.empty() ? usual_stiffness(simulation.model, patch) : stiffness);
  });
}

Grab Simulation::grab_vertex(std::uint32_t vertex, double stiffness) { return grab({&vertex, 1}, stiffness); }

Grab Simulation::grab_patch(const Vec3& point, double radius, double stiffness) {
  const Eigen::Vector3d place = vector_of(point, "grab_patch: point");
  if (!(radius > 0 && std::isfinite(radius))) throw Error("grab_patch: radius", "is not positive", "expected m");
  return impl_->call([&](fascia::Simulation& simulation) {
    const Model& model = simulation.model;
    std::vector<Eigen::Vector3d> x = simulation.state().displacement;
    for (std::size_t v = 0; v < x.size(); ++v) x[v] += model.rest_positions[v];
    const std::vector<PatchVertex> patch = fascia::grab_patch(model, x, place, radius, tet_at(model.tets, x, place));
    return impl_->take(patch, stiffness == 0 && !patch.empty() ? patch_stiffness(patch, radius) : stiffness);
  });
}

void Simulation::move(Grab grab, const Vec3& target) {
  const Eigen::Vector3d place = vector_of(target, "move: target");
  impl_->call([&](fascia::Simulation&) {
    impl_->find(grab).target = place;
    impl_->pull();
  });
}

Vec3 Simulation::target(Grab grab) const { return array_of(impl_->find(grab).target); }

double Simulation::stiffness(Grab grab) const {
  double sum = 0;
  for (const GrabSpring& spring : impl_->find(grab).springs) sum += spring.stiffness;
  return sum;
}

Vec3 Simulation::force(Grab grab) const {
  return impl_->call([&](fascia::Simulation& simulation) {
    const Impl::Held& held = impl_->find(grab);
    const fascia::State state = simulation.state();
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (const GrabSpring& spring : held.springs)
      force += spring.stiffness * (spring.target + held.target - held.center - state.displacement[spring.vertex]);
    return array_of(force);
  });
}

void Simulation::release(Grab grab) {
  impl_->call([&](fascia::Simulation&) {
    impl_->find(grab);
    impl_->held.erase(static_cast<std::uint32_t>(grab));
    impl_->pull();
  });
}

std::vector<Grab> Simulation::grabs() const {
  std::vector<Grab> names;
  for (const auto& [name, grab] : impl_->held) names.push_back(Grab(name));
  return names;
}

}  // namespace fascia::api
