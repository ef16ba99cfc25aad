#include "api/simulation.h"

#include "api/material.h"
#include "api/scene.h"
#include "api/settings.h"
#include "api/values.h"
#include "sim/bare_mesh/settled_model.h"
#include "sim/mesh/tet_faces.h"

namespace fascia::api {

Simulation::Impl::~Impl() {
  try {
    context.impl()->enter();
  } catch (...) {  // there is nothing to free once the context is gone
  }
  simulation.reset();
}

void Simulation::Impl::start(fascia::Scene scene, Model model, bool reference, const Progress& progress) {
  gl::ProgramCache* programs = context.impl()->programs.get();
  if (!programs && !reference)
    throw Error("context", "is none()", "expected an OpenGL context, or OpenOptions::reference");
  context.impl()->enter();
  simulation = std::make_unique<fascia::Simulation>(std::move(scene), std::move(model), programs, reference, progress);
  surface = boundary_triangles(simulation->model.tets);
}

Simulation Simulation::open(const std::string& path, Context context, const OpenOptions& options) {
  return Simulation(translated([&] {
    const Progress progress = progress_of(options.control, path);
    auto impl = std::make_unique<Impl>(std::move(context));
    fascia::Scene scene = open_scene(path, options.set);
    Model model = settled_model(scene, part_of(progress, 0, 0.5));
    impl->start(std::move(scene), std::move(model), options.reference, part_of(progress, 0.5, 1));
    return impl;
  }));
}

Simulation::Simulation(const Scene& scene, Context context, const OpenOptions& options)
    : impl_(translated([&] {
        if (!options.set.empty())
          throw Error("OpenOptions::set", "does not apply to a scene from arrays", "expected it empty");
        auto impl = std::make_unique<Impl>(std::move(context));
        BuiltScene built = build(scene);
        impl->start(std::move(built.scene), std::move(built.model), options.reference,
                    progress_of(options.control, "scene"));
        return impl;
      })) {}

Simulation::Simulation(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

const Context& Simulation::context() const { return impl_->context; }
std::vector<std::string> Simulation::notes() const { return impl_->simulation->model.notes; }

std::size_t Simulation::vertex_count() const { return impl_->simulation->model.rest_positions.size(); }
std::size_t Simulation::tet_count() const { return impl_->simulation->model.tets.size(); }

std::span<const double> Simulation::rest_positions() const {
  static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double));
  return {impl_->simulation->model.rest_positions.front().data(), 3 * vertex_count()};
}

std::span<const std::uint32_t> Simulation::tets() const {
  static_assert(sizeof(Tet) == 4 * sizeof(std::uint32_t));
  return {impl_->simulation->model.tets.front().data(), 4 * tet_count()};
}

std::span<const std::uint32_t> Simulation::surface_triangles() const {
  static_assert(sizeof(Triangle) == 3 * sizeof(std::uint32_t));
  return {impl_->surface.front().data(), 3 * impl_->surface.size()};
}

std::span<const std::uint32_t> Simulation::fixed() const { return impl_->simulation->model.fixed; }
std::vector<double> Simulation::masses() const { return lumped_masses(impl_->simulation->model); }

std::vector<BodyRange> Simulation::bodies() const {
  std::vector<BodyRange> ranges;
  for (const BodyPart& part : impl_->simulation->model.bodies)
    ranges.push_back({part.name, part.vertex_begin, part.vertex_count, part.tet_begin, part.tet_count});
  return ranges;
}

int Simulation::step(int count, const std::stop_token& stop) {
  if (count < 0) throw Error("step: count", "is " + std::to_string(count), "expected 0 or more");
  return impl_->call([&](fascia::Simulation& simulation) {
    int made = 0;
    for (; made < count && !stop.stop_requested(); ++made) simulation.step();
    return made;
  });
}

double Simulation::time() const { return impl_->simulation->time(); }
bool Simulation::asleep() const { return impl_->simulation->asleep(); }

void Simulation::reset() {
  impl_->call([](fascia::Simulation& simulation) { simulation.reset(); });
}

std::optional<std::uint32_t> Simulation::diverged_vertex() {
  return impl_->call([](fascia::Simulation& simulation) { return simulation.check_now(); });
}

void Simulation::restore_valid() {
  impl_->call([](fascia::Simulation& simulation) {
    if (simulation.uses_reference())
      throw Error("restore_valid", "not with the reference solver", "expected a simulation on the GPU");
    simulation.back_to_valid();
    simulation.begin_anew();
  });
}

StaticReport Simulation::solve_static(const std::stop_token& stop,
                                      const std::function<void(const StaticReport&)>& news) {
  const auto shown = [](const fascia::StaticReport& report) {
    return StaticReport{report.iterations, report.newton_iterations, report.relative_residual, report.converged};
  };
  return impl_->call([&](fascia::Simulation& simulation) {
    std::function<void(const fascia::StaticReport&)> tell;
    if (news) tell = [&](const fascia::StaticReport& report) { news(shown(report)); };
    return shown(simulation.solve_static(tell, stop));
  });
}

Settings Simulation::settings() const { return shown(impl_->simulation->scene.solver); }

void Simulation::set_settings(const Settings& settings) {
  const SolverSettings own = checked(settings);
  impl_->call([&](fascia::Simulation& simulation) { simulation.set_settings(own); });
}

Vec3 Simulation::gravity() const { return array_of(impl_->simulation->model.gravity); }

void Simulation::set_gravity(const Vec3& gravity) {
  const Eigen::Vector3d own = vector_of(gravity, "gravity");
  impl_->call([&](fascia::Simulation& simulation) { simulation.set_gravity(own); });
}

namespace {

void require_material(const Model& model, std::size_t index) {
  if (index >= model.materials.size())
    throw Error("material " + std::to_string(index), "does not exist",
                "expected an index below " + std::to_string(model.materials.size()));
}

}  // namespace

std::size_t Simulation::material_count() const { return impl_->simulation->model.materials.size(); }

std::string Simulation::material_name(std::size_t index) const {
  require_material(impl_->simulation->model, index);
  return impl_->simulation->model.material_names[index];
}

Material Simulation::material(std::size_t index) const {
  require_material(impl_->simulation->model, index);
  return shown(impl_->simulation->model.materials[index]);
}

void Simulation::set_material(std::size_t index, const Material& material) {
  require_material(impl_->simulation->model, index);
  const fascia::Material own = checked(material, "material " + std::to_string(index));
  impl_->call([&](fascia::Simulation& simulation) { simulation.set_material(index, own); });
}

}  // namespace fascia::api
