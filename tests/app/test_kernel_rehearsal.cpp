// What is compiled beside the window is what the scene then needs: the very programs, by name, of its steps, of its hands, and where
// regions rest.
#include <catch2/catch.hpp>
#include <set>

#include "app/kernel_warmer.h"
#include "app/opened.h"
#include "sim/gpu/solver.h"
#include "tests/app/headless.h"
#include "tests/sim/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

using Labels = std::set<std::string>;

// By the end of every part.
std::map<Rehearsed, Labels> rehearsed(gl::LoadPath loads, const SolverSettings& settings, const Model& model) {
  gl::ProgramCache programs(source_dir() / "shaders", loads);
  programs.set_fusing(true);
  std::map<Rehearsed, Labels> done;
  rehearse(programs, kernel_use(settings, model), rehearsal_body(model), [&](Rehearsed part) {
    const std::vector<std::string> labels = programs.labels();
    done.try_emplace(part, labels.begin(), labels.end());  // when it is told of first
    return true;
  });
  return done;
}

// What `programs` has that was not rehearsed.
std::string missing(const gl::ProgramCache& programs, const Labels& rehearsed) {
  std::string names;
  for (const std::string& label : programs.labels())
    if (!rehearsed.contains(label)) names += label + "\n";
  return names;
}

std::vector<GrabSpring> hand(const Model& model) {
  const std::vector<char> held = model.held();
  std::vector<GrabSpring> springs;
  for (std::uint32_t v = static_cast<std::uint32_t>(held.size()); v-- > 0 && springs.size() < 5;)
    if (!held[v]) springs.push_back({v, Vector3d(0, 0.002, 0), 50});
  return springs;
}

// Steps, then a hand, then both again while most of it rests if it can, as a window has them.
void require_rehearsed(const Model& model, const SolverSettings& settings, gl::LoadPath loads) {
  const std::map<Rehearsed, Labels> done = rehearsed(loads, settings, model);
  gl::ProgramCache programs(source_dir() / "shaders", loads);
  programs.set_fusing(true);
  GpuSolver solver(programs, model, settings, model.embedded);
  const auto frame = [&] {
    solver.step();
    solver.request_diagnostics();
    solver.take_diagnostics(true);
    solver.publish();
  };
  for (int i = 0; i < 2; ++i) frame();
  solver.request_check();
  solver.take_check(true);
  CHECK(missing(programs, done.at(Rehearsed::steps)) == "");
  solver.set_grab(hand(model));
  for (int i = 0; i < 2; ++i) frame();
  CHECK(missing(programs, done.at(Rehearsed::hands)) == "");
  for (int i = 0; i < 6; ++i) frame();
  solver.set_grab({});
  for (int i = 0; i < 8; ++i) frame();
  CHECK(missing(programs, done.at(Rehearsed::all)) == "");
}

Model beam(int cells_along, const Material& material) {
  return make_model(make_box(cells_along, 4, 4, {0.05 * cells_along, 0.2, 0.2}), material, [](const Vector3d& x) { return x.x() < 1e-9; });
}

}  // namespace

TEST_CASE("a rehearsal compiles what the scene then asks for, with every method") {
  const Gpu gpu;
  const Pair pair = GENERATE(Pair{Method::two_level, Acceleration::subspace}, Pair{Method::two_level, Acceleration::anderson},
                             Pair{Method::vertex_descent, Acceleration::anderson}, Pair{Method::exact_xpbd, Acceleration::anderson},
                             Pair{Method::gauss_seidel, Acceleration::none}, Pair{Method::jacobi, Acceleration::chebyshev},
                             Pair{Method::mass_splitting, Acceleration::anderson_positions});
  CAPTURE(name_of(pair.method), name_of(pair.acceleration));
  SolverSettings settings;
  settings.method = pair.method;
  settings.acceleration = pair.acceleration;
  Model model = beam(24, {1e4, 0.3, 1000, 0.01});
  model.materials.push_back({1e5, 0.3, 1000, 0});
  for (std::size_t t = 0; t < model.tets.size(); t += 3) model.tet_material[t] = 1;
  require_rehearsed(model, settings, gl::LoadPath::texel);
}

TEST_CASE("a rehearsal compiles what the shipped scenes then ask for") {
  const Gpu gpu;
  const auto name = GENERATE("liver", "kidney", "inclusion", "cube", "liver_hands");
  CAPTURE(name);
  const Scene scene = open_scene(source_dir() / "assets/scenes" / (std::string(name) + ".json"));
  require_rehearsed(build_model(scene), scene.solver, gl::LoadPath::texel);
}

TEST_CASE("a rehearsal compiles what small, moved, free and stopped bodies ask for, however their kernels read") {
  const Gpu gpu;
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  SolverSettings settings;
  Model model = beam(5, {1e4, 0.3, 1000, 0});
  SECTION("small") {}
  SECTION("a few tets") { model = make_model(make_box(1, 1, 1, {0.1, 0.1, 0.1}), {}, [](const Vector3d& x) { return x.x() < 1e-9; }); }
  SECTION("prescribed") {
    Motion& motion = model.motions.emplace_back();
    motion.vertices = {40};
    motion.targets = {model.rest_positions[40]};
    motion.duration = 0.1;
  }
  SECTION("free") { model.fixed.clear(); }
  SECTION("to a tolerance") { settings.tolerance = 1e-3; }
  SECTION("never at rest") {
    model = beam(24, {1e4, 0.3, 1000, 0});
    settings.rest_speed = 0;
  }
  SECTION("few colors") {
    settings.method = Method::gauss_seidel;
    settings.acceleration = Acceleration::none;
    settings.colors = 3;
  }
  const bool any_material = settings.method == Method::two_level;
  if (!any_material) require_rehearsed(model, settings, loads);
  for (const MaterialModel kind : {MaterialModel::stable_neo_hookean, MaterialModel::st_venant_kirchhoff}) {
    if (!any_material) break;
    model.materials[0].model = kind;
    require_rehearsed(model, settings, loads);
  }
}

TEST_CASE("some regions of the body rest while a hand holds its end, and while it moves by itself") {
  const Gpu gpu;
  Model model = beam(24, {});
  const std::map<Rehearsed, Labels> done = rehearsed(gl::LoadPath::texel, {}, model);
  REQUIRE(done.contains(Rehearsed::all));
  CHECK(done.at(Rehearsed::all).size() > done.at(Rehearsed::hands).size());

  INFO("and so do those of a body like it, whose programs are among them");
  model.gravity.setZero();
  gl::ProgramCache programs(source_dir() / "shaders", gl::LoadPath::texel);
  programs.set_fusing(true);
  GpuSolver solver(programs, model, {});
  for (int held = 1; held >= 0; --held) {
    solver.set_grab(held ? std::vector<GrabSpring>{{static_cast<std::uint32_t>(model.rest_positions.size() - 1), Vector3d::Zero(), 10}} : std::vector<GrabSpring>());
    for (int i = 0; i < 8; ++i) solver.step();
  }
  REQUIRE(solver.share_solved() < 1);
  CHECK(missing(programs, done.at(Rehearsed::all)) == "");
}

TEST_CASE("a rehearsal has buffers of the scene's sizes, which drivers compile for") {
  const Gpu gpu;
  const Scene scene = open_scene(source_dir() / "assets/scenes/kidney.json");
  const Model model = build_model(scene);
  gl::ProgramCache programs(source_dir() / "shaders", gl::LoadPath::texel);
  programs.set_fusing(true);
  std::map<std::string, std::size_t> sizes;
  rehearse(programs, kernel_use(scene.solver, model), rehearsal_body(model), [&](Rehearsed) { return sizes = gl::bytes_by_buffer(), false; });
  const GpuSolver solver(programs, model, scene.solver, model.embedded);
  CHECK(sizes == gl::bytes_by_buffer());
}

TEST_CASE("a rehearsal ends where it is told to") {
  const Gpu gpu;
  gl::ProgramCache programs(source_dir() / "shaders", gl::LoadPath::texel);
  programs.set_fusing(true);
  int asked = 0;
  const Model model = beam(5, {});
  rehearse(programs, kernel_use({}, model), rehearsal_body(model), [&](Rehearsed part) { return ++asked, part < Rehearsed::steps; });
  CHECK(asked == 2);
}

TEST_CASE("without a context beside the window's all counts as compiled") {
  const Graphics graphics = open_graphics(headless(), false);
  KernelWarmer warmer(graphics, {});
  CHECK(warmer.compiled({}, beam(5, {})) == Rehearsed::all);
}
