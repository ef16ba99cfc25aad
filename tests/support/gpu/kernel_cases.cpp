#include "tests/support/gpu/kernel_cases.h"

#include "sim/gpu/readback/lowest_point.h"
#include "sim/material/law.h"
#include "tests/support/models.h"
#include "tests/support/touching_bodies.h"

namespace fascia::test {
namespace {

using Eigen::Vector3d;

const Vector3d kSize(0.12, 0.06, 0.06);

Material tissue_of(MaterialModel law, double damping = 0) { return {2e4, 0.4, 1000, damping, law}; }

Model small_bar(const Material& material) { return make_model(make_box(4, 2, 2, kSize), material, at_left_end); }

SolverSettings settings_of(SolverChoice choice) {
  SolverSettings settings = frames();
  settings.method = choice.method;
  settings.acceleration = choice.acceleration;
  settings.iterations = 6;
  settings.rest_speed = 0;
  return settings;
}

const SolverChoice kBest{Method::two_level, Acceleration::subspace};
const Material kSigned = tissue_of(MaterialModel::signed_st_venant_kirchhoff);
const Material kDamped = tissue_of(MaterialModel::signed_st_venant_kirchhoff, 0.02);

Model moved_by_its_end() {
  Model model = small_bar(kDamped);
  Motion motion;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v)
    if (model.rest_positions[v].x() > kSize.x() - 1e-9) motion.vertices.push_back(v);
  motion.translate = {0.01, 0, 0};
  motion.duration = 0.1;
  model.motions = {motion};
  return model;
}

Model of_two_materials() {
  Model model = small_bar(kDamped);
  model.materials.push_back(tissue_of(MaterialModel::stable_neo_hookean, 0.02));
  model.material_names.push_back("body: other");
  for (std::size_t t = 0; t < model.tets.size(); t += 3) model.tet_material[t] = 1;
  return model;
}

Tool tool_of(const std::string& name, const ToolShape& shape, const Vector3d& place = {0, 0, 0}) {
  Tool tool;
  tool.name = name;
  tool.shape = shape;
  tool.friction = 0.4;
  tool.path = {{0, place, {0, 0, 0}}};
  return tool;
}

Model on_the_ground(Model model) {
  model.tools = {tool_of("ground", PlaneShape{{0, 0.001, 0}, {0, 1, 0}}),
                 tool_of("ball", SphereShape{{0, 0, 0}, 0.02}, {0.06, 0.078, 0.03})};
  return model;
}

// Held at rest by nothing, above another one.
Model stacked() {
  const Model below = small_bar(kSigned);
  return on_the_ground(beside(below, moved(small_bar(kSigned), {0, 0.0601, 0}, {0, -0.2, 0}), "above"));
}

// Long enough for a part of it to rest while another part moves.
Model long_bar(const Material& material) {
  return make_model(make_box(24, 4, 4, {0.6, 0.1, 0.1}), material, at_left_end);
}

EmbeddedPoints some_points(const Model& model) {
  return embed({kSize / 3, kSize / 2}, model.rest_positions, model.tets, model.mid_edges);
}

}  // namespace

std::vector<KernelCase> kernel_cases() {
  std::vector<KernelCase> cases;
  const auto add = [&](const std::string& name, Model model, const SolverSettings& settings) -> KernelCase& {
    return cases.emplace_back(name, std::move(model), settings);
  };
  for (const SolverChoice& choice : solver_choices()) {
    const std::string name = std::string(name_of(choice.method)) + " + " + name_of(choice.acceleration);
    add(name, small_bar(kSigned), settings_of(choice));
    add(name + ", grabbed and damped", small_bar(kDamped), settings_of(choice)).grabbed = true;
    SolverSettings tolerant = settings_of(choice);
    tolerant.tolerance = 1e-9;
    add(name + ", with a tolerance", small_bar(kSigned), tolerant);
  }
  for (const MethodInfo& method : methods())
    for (const MaterialLaw* law : material_laws())
      if (method.carries_every_law || law->of_strain)
        add(std::string("damped ") + law->name + ", " + method.name, small_bar(tissue_of(law->model, 0.02)),
            settings_of({method.method, method.accelerations.front()}));
  for (const IntegratorInfo& integrator : integrators()) {
    SolverSettings settings = settings_of(kBest);
    settings.integrator = integrator.integrator;
    add(integrator.name, small_bar(kDamped), settings);
  }
  SolverSettings few_colors = settings_of({Method::gauss_seidel, Acceleration::none});
  few_colors.colors = 5;
  add("phantoms", small_bar(kSigned), few_colors);
  add("two materials", of_two_materials(), settings_of(kBest)).every_heat_map = true;
  add("moved by its end", moved_by_its_end(), settings_of(kBest));
  add("compensated", small_bar(kSigned), settings_of(kBest)).compensated = true;
  for (const MaterialLaw* law : material_laws()) {
    Material material = tissue_of(law->model, 0.02);
    material.poisson_ratio = 0.49;  // K is relaxed
    add(std::string("quadratic, ") + law->name, quadratic(small_bar(material)), settings_of(kBest));
  }
  Model half_quadratic = beside(small_bar(kSigned), moved(small_bar(kSigned), {0, 0.2, 0}), "quadratic");
  half_quadratic.contact.bodies = false;
  const auto half = static_cast<std::uint32_t>(half_quadratic.tets.size() / 2);
  cases.back().every_heat_map = true;
  KernelCase& mixed = add("linear and quadratic", quadratic(std::move(half_quadratic), half), settings_of(kBest));
  mixed.grabbed = mixed.every_heat_map = true;
  KernelCase& lies = add("on the ground", on_the_ground(small_bar(kSigned)), settings_of(kBest));
  lies.grabbed = lies.every_heat_map = true;
  add("stacked", stacked(), settings_of(kBest));
  SolverSettings stops = settings_of(kBest);
  stops.tolerance = 1e-9;
  add("stacked, with a tolerance", stacked(), stops);
  add("quadratic on the ground", on_the_ground(quadratic(small_bar(kDamped))), settings_of(kBest));
  for (const Acceleration acceleration : {Acceleration::subspace, Acceleration::nonlinear_cg}) {
    SolverSettings resting = settings_of({Method::two_level, acceleration});
    resting.rest_speed = 1e-5;
    add(std::string("resting regions, ") + name_of(acceleration), long_bar(kDamped), resting);
  }
  return cases;
}

void run_all(const KernelCase& example, gl::ProgramCache& programs, const std::function<void(GpuSolver&)>& after_step) {
  const Model& model = example.model;
  GpuSolver solver(programs, model, example.settings, some_points(model));
  const auto tip = static_cast<std::uint32_t>(model.rest_positions.size() - 1);
  if (example.grabbed) solver.set_grab({{tip, {0, 0.01, 0}, 20}, {tip - 1, {0, 0.01, 0}, 20}});
  if (example.compensated) solver.set_compensated(true);
  LowestPoint lowest(programs, solver.positions(), {0, tip});
  for (int color = 0; color <= static_cast<int>(ColorBy::recovered_von_mises); ++color) {
    if (color > 1 && !example.every_heat_map) continue;
    solver.set_color(static_cast<ColorBy>(color));
    if (color < 2) solver.step();
    solver.publish();
    if (ShownRange* range = solver.shown_range()) {
      range->request();
      range->take(true);
    }
    lowest.request();
    lowest.take(true);
    if (after_step) after_step(solver);
  }
  solver.request_diagnostics();
  solver.take_diagnostics(true);
  solver.request_check();
  solver.take_check(true);
  solver.step();
  solver.run_partial_kernels();
  solver.traced_substep();
  solver.contact_forces();
  solver.mean_iterations();
  solver.upload(solver.download());
  solver.restore_valid(true);
  solver.step();
}

}  // namespace fascia::test
