// Every kernel that all methods share, alone, against the same pass in double precision on random states.
// Tolerances: one or a few float32 operations per output, 6e-8 each; sums of n terms grow it by at most n.
#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "sim/locality.h"
#include "sim/gpu/solver.h"
#include "sim/reference/elasticity.h"
#include "tests/sim/gpu/double_xpbd.h"
#include "tests/sim/gpu/gpu_fixture.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;
using shared::vec4;

namespace {

const Material soft{2e4, 0.35, 1050, 0, MaterialModel::st_venant_kirchhoff};

Model block() {
  return make_model(make_box(5, 4, 3, {0.1, 0.08, 0.06}), soft, [](const Vector3d& x) { return x.y() < 1e-9; });
}

std::vector<Vector3d> unpack(const gl::Buffer& buffer) {
  std::vector<Vector3d> out;
  for (const vec4& v : buffer.read<vec4>()) out.emplace_back(v.x, v.y, v.z);
  return out;
}

}  // namespace

TEST_CASE("predict adds velocity and gravity to free vertices only", "[gpu]") {
  const bool split = GENERATE(false, true);
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  Gpu gpu(loads);
  const Model model = block();
  SimBuffers buffers(model);
  SolverSettings settings;
  settings.time_step = 1.0 / 90;
  const double h = settings.substep();
  buffers.upload_step(model, settings);
  const reference::State state = random_state(model, 0.01, 1);
  buffers.upload_state(model, state);
  prediction(gpu.programs, buffers, split ? &buffers.tet_begin : nullptr).run();
  const std::vector<char> held = model.held();
  const std::vector<double> mass = lumped_masses(model);
  std::vector<Vector3d> expected = state.displacement;
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (!held[i]) expected[i] += h * (state.velocity[i] + h * model.gravity);
  CHECK(relative_rms(unpack(buffers.displacement), expected) < 3e-7);
  CHECK(relative_rms(unpack(buffers.predicted), expected) < 3e-7);
  CHECK(relative_rms(unpack(buffers.previous_displacement), state.displacement) == 0);
  const std::vector<vec4> values = buffers.displacement.read<vec4>(), predicted = buffers.predicted.read<vec4>();
  std::vector<int> valence(values.size(), 0);
  for (const Tet& tet : model.tets)
    for (const auto v : tet) ++valence[v];
  for (std::size_t i = 0; i < values.size(); ++i) {
    CAPTURE(i);
    CHECK(predicted[i].w == Approx(held[i] ? 0 : 1 / mass[i]).epsilon(1e-6));
    CHECK(values[i].w == Approx(held[i] ? 0 : (split ? valence[i] : 1) / mass[i]).epsilon(1e-6));
  }
}

TEST_CASE("velocity is the change of displacement over the substep", "[gpu]") {
  Gpu gpu;
  const Model model = block();
  SimBuffers buffers(model);
  const SolverSettings settings;
  const double h = settings.substep();
  buffers.upload_step(model, settings);
  const reference::State now = random_state(model, 0.01, 1), before = random_state(model, 0.01, 2);
  buffers.upload_state(model, before);
  const std::vector<vec4> previous = buffers.displacement.read<vec4>();
  buffers.previous_displacement.upload(0, buffers.previous_displacement.bytes(), previous.data());
  buffers.upload_state(model, now);
  gl::ComputePass(gpu.programs.compute("sim/velocity.comp"),
                  {{"step", &buffers.step},
                   {"displacement", &buffers.displacement},
                   {"previous_displacement", &buffers.previous_displacement},
                   {"predicted", &buffers.predicted},
                   {"velocity", &buffers.velocity},
                   {"astray", &buffers.astray}},
                  buffers.vertex_count)
      .run();
  std::vector<Vector3d> expected;
  for (std::size_t i = 0; i < now.displacement.size(); ++i)
    expected.push_back((now.displacement[i] - before.displacement[i]) / h);
  CHECK(relative_rms(unpack(buffers.velocity), expected) < 3e-7);
}

TEST_CASE("previous strain is the Green strain of the start of the substep", "[gpu]") {
  Gpu gpu;
  const Model model = block();
  SimBuffers buffers(model);
  const reference::State state = random_state(model, 0.004, 6);
  buffers.upload_state(model, state);
  const std::vector<vec4> u = buffers.displacement.read<vec4>();
  buffers.previous_displacement.upload(0, buffers.previous_displacement.bytes(), u.data());
  const gl::Buffer strain("strain", 2 * sizeof(vec4) * buffers.tet_count);
  gl::ComputePass(gpu.programs.compute("sim/previous_strain.comp"),
                  with_pairs({{"previous_displacement", &buffers.previous_displacement}, {"previous_strain", &strain}}, buffers),
                  buffers.pair_and_single_count(), constants_of_pairs(buffers))
      .run();
  const DoubleXpbd exact(model, {});
  std::vector<Vector3d> expected;
  for (const std::uint32_t t : paired_tets(model).order) {
    const Vector6d e = exact.strain(t, state.displacement);
    expected.push_back(e.head<3>());
    expected.push_back(e.tail<3>());
  }
  CHECK(relative_rms(unpack(strain), expected) < 1e-6);
}

TEST_CASE("diagnostics leave no pair of tets and no vertex out, however many there are", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  Gpu gpu(loads);
  for (const auto& [x, y, z] : {std::tuple(11, 8, 6), {12, 7, 5}, {12, 9, 7}, {17, 8, 8}}) {
    const Model model = make_model(make_box(x, y, z, {0.1 * x, 0.1 * y, 0.1 * z}), {1e5, 0.3, 1000}, [](const Vector3d& at) { return at.x() < 1e-9; });
    GpuSolver solver(gpu.programs, model, {});
    const reference::State state = random_state(model, 0.004, 4);
    solver.upload(state);
    solver.set_color(ColorBy::displacement);
    solver.publish();
    solver.shown_range()->request();
    solver.request_diagnostics();
    const auto got = solver.take_diagnostics(true);
    const auto shown = solver.shown_range()->take(true);
    REQUIRE(got);
    REQUIRE(shown);
    const reference::Measures expected = reference::measure(model, state);
    double farthest = 0;
    for (const Vector3d& u : state.displacement) farthest = std::max(farthest, u.norm());
    CAPTURE(gl::name_of(loads), x, y, z, got->elastic, expected.elastic, got->reaction.transpose(), expected.fixed_reaction.transpose());
    CHECK(got->kinetic == Approx(expected.kinetic).epsilon(2e-6));
    CHECK(got->elastic == Approx(expected.elastic).epsilon(5e-6));
    CHECK((got->momentum - expected.momentum).norm() < 1e-5 * expected.momentum.norm());
    CHECK((got->reaction - expected.fixed_reaction).norm() < 1e-5 * expected.fixed_reaction.norm());
    CHECK(got->max_det_f == Approx(expected.max_det_f).epsilon(1e-5));
    CHECK(shown->y() == Approx(farthest).epsilon(1e-6));
  }
}

TEST_CASE("tets that are left out of the solve count among the volume ratios, as they are at rest", "[gpu]") {
  Gpu gpu;
  const double held_up_to = GENERATE(0.05, 1.0);  // m: of tets one layer or all
  Model model = make_model(make_box(5, 4, 3, {0.1, 0.08, 0.06}), soft, [&](const Vector3d& x) { return x.y() < held_up_to; });
  reference::State state = reference::initial_state(model);
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < held.size(); ++v)
    if (!held[v]) state.displacement[v].y() = 0.02;  // all free tets grow
  GpuSolver solver(gpu.programs, model, {});
  solver.upload(state);
  solver.request_diagnostics();
  const auto got = solver.take_diagnostics(true);
  REQUIRE(got);
  const reference::Measures expected = reference::measure(model, state);
  CAPTURE(held_up_to, got->min_det_f, got->max_det_f, expected.max_det_f);
  CHECK(expected.min_det_f == Approx(1));
  CHECK(got->min_det_f == Approx(expected.min_det_f));
  CHECK(got->max_det_f == Approx(expected.max_det_f));
}

TEST_CASE("springs lie at their vertices, however far these are from each other, and are gone after them", "[gpu]") {
  Gpu gpu;
  const Model model = make_model(make_box(19, 12, 11, {0.19, 0.12, 0.11}), soft, [](const Vector3d& x) { return x.y() < 1e-9; });  // 3,120 vertices
  const SimBuffers buffers(model);
  GrabSprings grab;
  grab.set_use(false, true, buffers.vertex_count);
  const auto check = [&](const std::vector<GrabSpring>& springs) {
    grab.set(springs);
    gl::ComputePass::Bindings bindings;
    grab.with_springs({}, bindings);
    REQUIRE(bindings.size() == 1);
    std::vector<vec4> expected(buffers.vertex_count, vec4{});
    for (const GrabSpring& s : springs) expected[s.vertex] = {static_cast<float>(s.target.x()), 0, 0, static_cast<float>(s.stiffness)};
    const std::vector<vec4> got = bindings[0].second->read<vec4>();
    for (std::size_t v = 0; v < got.size(); ++v) {
      CAPTURE(v);
      REQUIRE((got[v].x == expected[v].x && got[v].w == expected[v].w));
    }
  };
  check({{3000, {1, 0, 0}, 5}, {7, {2, 0, 0}, 6}, {12, {3, 0, 0}, 7}, {1032, {4, 0, 0}, 8}});
  check({{3000, {9, 0, 0}, 5}, {7, {8, 0, 0}, 6}, {12, {7, 0, 0}, 7}, {1032, {6, 0, 0}, 8}});
  check({{2000, {1, 0, 0}, 3}});
}

TEST_CASE("a hand without stiffness changes nothing", "[gpu]") {
  Gpu gpu;
  const Model model = block();
  const auto method = GENERATE(Method::jacobi, Method::gauss_seidel, Method::exact_xpbd, Method::vertex_descent, Method::two_level);
  SolverSettings settings;
  settings.method = method;
  settings.acceleration = method == Method::two_level ? Acceleration::subspace : Acceleration::none;
  GpuSolver free(gpu.programs, model, settings), held(gpu.programs, model, settings);
  held.set_grab({{static_cast<std::uint32_t>(model.rest_positions.size() - 1), {0.1, 0.1, 0}, 0}});
  for (int i = 0; i < 5; ++i) {
    free.step();
    held.step();
  }
  const double distance = farthest(held.download(), free.download()), size = free.buffers().size;
  CAPTURE(name_of(method), distance);
  CHECK(distance < 1e-6 * size);
}

TEST_CASE("diagnostics equal the reference measures", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  const bool two_materials = GENERATE(false, true);
  const MaterialModel of_first = GENERATE(from_range(material_models()));
  CAPTURE(gl::name_of(loads), two_materials, name_of(of_first));
  Gpu gpu(loads);
  Model model = block();
  model.materials[0].model = of_first;
  if (two_materials) {
    model.materials.push_back({9e4, 0.45, 2000, 0, MaterialModel::st_venant_kirchhoff});
    for (std::size_t t = 0; t < model.tets.size(); t += 2) model.tet_material[t] = 1;
  }
  GpuSolver solver(gpu.programs, model, {});
  const reference::State state = random_state(model, 0.004, 4);
  solver.upload(state);
  solver.set_probe(17);
  solver.request_diagnostics();
  const auto got = solver.take_diagnostics(true);
  REQUIRE(got);
  const reference::Measures expected = reference::measure(model, state);
  const auto close = [](const Vector3d& a, const Vector3d& b) {
    INFO("got " << a.transpose() << ", expected " << b.transpose());
    CHECK((a - b).norm() < 3e-6 * b.norm());
  };
  CHECK(got->kinetic == Approx(expected.kinetic).epsilon(2e-6));
  CHECK(got->elastic == Approx(expected.elastic).epsilon(5e-6));
  // A sum of both signs: the rounding is that of its largest terms.
  double weights = 0;
  const std::vector<double> mass = lumped_masses(model);
  for (std::size_t v = 0; v < mass.size(); ++v) weights += std::abs(mass[v] * model.gravity.dot(state.displacement[v]));
  CHECK(got->gravitational == Approx(expected.gravitational).margin(5e-7 * weights));
  CHECK(std::abs(got->volume_ratio - expected.volume_ratio) < 5e-6);
  REQUIRE(got->probe);
  CHECK((*got->probe - state.displacement[17]).norm() <= 6e-8 * state.displacement[17].norm());
  CHECK(got->time == state.time);
  close(got->momentum, expected.momentum);
  close(got->angular_momentum, expected.angular_momentum);
  close(got->reaction, expected.fixed_reaction);
  CHECK(got->min_det_f == Approx(expected.min_det_f).epsilon(1e-5));
  CHECK(got->max_det_f == Approx(expected.max_det_f).epsilon(1e-5));
  CHECK(got->rms_strain == Approx(expected.rms_strain).epsilon(2e-6));
  CHECK(got->inverted == expected.inverted);
  CHECK(got->finite);
  reference::State lost = state;
  lost.displacement[17].y() = std::numeric_limits<double>::quiet_NaN();
  solver.upload(lost);
  solver.set_probe(std::nullopt);
  solver.request_diagnostics();
  const auto broken = solver.take_diagnostics(true);
  CHECK_FALSE(broken->finite);
  CHECK_FALSE(broken->probe);

  const StateFields fields = reference::export_fields(model, state);
  double strain = 0, stress = 0;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const auto& e = fields.green_strain[t];
    strain = std::max(strain, std::sqrt(e.head<3>().squaredNorm() + 2 * e.tail<3>().squaredNorm()));
    stress = std::max(stress, fields.von_mises[t]);
  }
  CHECK(got->max_strain == Approx(strain).epsilon(1e-5));
  CHECK(got->max_von_mises == Approx(stress).epsilon(1e-4));  // divided by J, whose smallest value is near zero here
}

TEST_CASE("the residual is zero for the exact implicit Euler step and one for the untouched prediction", "[gpu]") {
  Gpu gpu;
  Model model = block();
  model.gravity.setZero();  // a load would count in the scale
  const SolverSettings settings;
  reference::NewtonSolver newton(model, settings);
  reference::State state = random_state(model, 0.002, 12);
  const reference::State before = state;
  newton.step(state);

  GpuSolver solver(gpu.programs, model, settings);
  const SimBuffers& buffers = solver.buffers();
  const auto residual_with = [&](const std::vector<Vector3d>& displacement) {
    // A step leaves the prediction of `before` in the buffers; then the displacement is put in place of its result.
    solver.upload(before);
    solver.step();
    reference::State replaced = before;
    replaced.displacement = displacement;
    solver.upload(replaced);
    solver.request_diagnostics();
    return solver.take_diagnostics(true)->residual;
  };
  const double exact = residual_with(state.displacement);
  const double prediction = residual_with(buffers.download_vectors(buffers.predicted));
  CAPTURE(exact, prediction);
  CHECK(exact < 2e-5);  // float32 displacements of 1e-3 relative to their differences
  CHECK(prediction == Approx(1.0).epsilon(1e-5));
}

TEST_CASE("published positions and heat map scalars", "[gpu]") {
  const auto color = GENERATE(ColorBy::none, ColorBy::region, ColorBy::strain, ColorBy::von_mises, ColorBy::displacement, ColorBy::velocity,
                              ColorBy::volume_ratio, ColorBy::largest_stress, ColorBy::smallest_stress);
  const auto law = GENERATE(MaterialModel::st_venant_kirchhoff, MaterialModel::signed_st_venant_kirchhoff, MaterialModel::stable_neo_hookean);
  Gpu gpu;
  Model model = block();
  model.materials[0].model = law;
  GpuSolver solver(gpu.programs, model, {});
  const reference::State state = random_state(model, 0.002, 5);
  solver.upload(state);
  solver.set_color(color);
  solver.publish();
  const std::vector<vec4> got = solver.positions().read<vec4>();
  // Of each tet, in double precision.
  const auto value_of = [&](const Tet& tet) {
    const auto& x = model.rest_positions;
    const auto& u = state.displacement;
    const reference::RestTet rest({x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]});
    const reference::Corners corners{u[tet[0]], u[tet[1]], u[tet[2]], u[tet[3]]};
    const Eigen::Matrix3d f = reference::deformation_gradient(rest, corners);
    if (color == ColorBy::strain) return reference::green_strain_matrix(rest, corners).norm();
    if (color == ColorBy::von_mises) return reference::von_mises(f, model.materials[0]);
    if (color == ColorBy::volume_ratio) return f.determinant();
    const Eigen::Matrix3d cauchy = reference::first_piola_stress(f, model.materials[0]) * f.transpose() / std::abs(f.determinant());
    const Vector3d principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(0.5 * (cauchy + cauchy.transpose())).eigenvalues();
    return color == ColorBy::largest_stress ? principal[2] : principal[0];
  };
  std::vector<double> weight(got.size(), 0), scalar(got.size(), 0);
  double size = 0;  // of the values, for those that nearly cancel
  for (const Tet& tet : model.tets) {
    const auto& x = model.rest_positions;
    const double volume = signed_volume6(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) / 6, value = value_of(tet);
    size = std::max(size, std::abs(value));
    for (const auto v : tet) {
      weight[v] += volume;
      scalar[v] += volume * value;
    }
  }
  Eigen::Vector2d range(1e300, -1e300);
  for (std::size_t i = 0; i < got.size(); ++i) {
    const Vector3d expected = model.rest_positions[i] + state.displacement[i];
    CAPTURE(color, law, i, got[i].x, got[i].y, got[i].z, got[i].w, expected.transpose());
    CHECK((Vector3d(got[i].x, got[i].y, got[i].z) - expected).norm() < 2e-8);
    double shown = scalar[i] / weight[i];
    if (!is_heat_map(color)) shown = 0;
    if (color == ColorBy::displacement) shown = state.displacement[i].norm();
    if (color == ColorBy::velocity) shown = state.velocity[i].norm();
    // Stresses cancel in F S F^T and are divided by J, which is small in some tets here.
    const double margin = color == ColorBy::largest_stress || color == ColorBy::smallest_stress ? 1e-5 * size : 0;
    CHECK(got[i].w == Approx(shown).epsilon(1e-5).margin(margin));
    range = {std::min<double>(range.x(), got[i].w), std::max<double>(range.y(), got[i].w)};
  }
  CHECK((solver.shown_range() != nullptr) == is_heat_map(color));
  if (!solver.shown_range()) return;
  solver.shown_range()->request();
  const auto found = solver.shown_range()->take(true);
  REQUIRE(found);
  CHECK(*found == range);
  CHECK(!solver.shown_range()->take(true));
}

TEST_CASE("principal stresses keep their digits where two are equal", "[gpu]") {
  // One tet stretched along an axis that is none of the coordinates': uniaxial strain, two equal smaller stresses.
  Gpu gpu;
  TetMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tets = {{0, 1, 2, 3}};
  mesh.regions = {0};
  const Model model = make_model(mesh, soft, [](const Vector3d&) { return false; });
  GpuSolver solver(gpu.programs, model, {});
  const Vector3d axis = Vector3d(1, 2, -0.5).normalized();
  const double stretch = 0.25, strain = stretch + 0.5 * stretch * stretch, ratio = 1 + stretch;
  reference::State state = reference::initial_state(model);
  for (std::size_t i = 0; i < 4; ++i) state.displacement[i] = stretch * axis * axis.dot(mesh.positions[i]);
  solver.upload(state);
  const double lambda = soft.young_modulus * soft.poisson_ratio / ((1 + soft.poisson_ratio) * (1 - 2 * soft.poisson_ratio));
  const double mu = soft.young_modulus / (2 * (1 + soft.poisson_ratio));
  const double along = (lambda + 2 * mu) * strain * ratio, across = lambda * strain / ratio;
  const auto shown = [&](ColorBy color) {
    solver.set_color(color);
    solver.publish();
    return static_cast<double>(solver.positions().read<vec4>()[0].w);
  };
  CHECK(shown(ColorBy::largest_stress) == Approx(along).epsilon(2e-6));
  CHECK(shown(ColorBy::smallest_stress) == Approx(across).epsilon(2e-6));
  CHECK(shown(ColorBy::volume_ratio) == Approx(ratio).epsilon(1e-6));
}

TEST_CASE("a grab spring alone obeys implicit Euler", "[gpu]") {
  // One tet so soft that only the spring acts: (m / h^2 + k) (u - target) = m / h^2 (u~ - target).
  Gpu gpu;
  TetMesh mesh;
  mesh.positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}};
  mesh.tets = {{0, 1, 2, 3}};
  mesh.regions = {0};
  Model model = make_model(mesh, {1e-3, 0.3, 1000, 0, MaterialModel::st_venant_kirchhoff}, [](const Vector3d&) { return false; });
  model.gravity.setZero();
  SolverSettings settings;
  GpuSolver solver(gpu.programs, model, settings);
  const double m = lumped_masses(model)[1], h = settings.substep();
  const double stiffness = GENERATE(1e-2, 1e1, 1e5);
  const Vector3d target(0.03, -0.02, 0.01);
  solver.set_grab({{1, target, stiffness}});
  solver.step();
  const Vector3d expected = target * stiffness / (m / (h * h) + stiffness);
  const reference::State state = solver.download();
  CAPTURE(stiffness, state.displacement[1].transpose(), expected.transpose());
  CHECK((state.displacement[1] - expected).norm() < 1e-4 * expected.norm());
  solver.request_diagnostics();
  const auto diagnostics = solver.take_diagnostics(true);
  const Vector3d force = stiffness * (target - expected);
  CAPTURE(diagnostics->grab_force.transpose(), force.transpose());
  CHECK((diagnostics->grab_force - force).norm() < 1e-3 * force.norm());
  CHECK(diagnostics->residual < 1e-4);  // the spring counts as a load

  solver.set_grab({});
  solver.step();
  solver.request_diagnostics();
  CHECK(solver.take_diagnostics(true)->grab_force.norm() == 0);
}

TEST_CASE("prescribed vertices follow their motion exactly", "[gpu]") {
  Gpu gpu;
  Model model = block();
  Motion motion;
  motion.vertices = {30, 31, 32};
  motion.translate = {0.01, 0.02, -0.01};
  motion.start = 0.05;
  motion.duration = 0.1;
  model.motions = {motion};
  GpuSolver solver(gpu.programs, model, {});
  for (int step = 1; step <= 12; ++step) {
    solver.step();
    const reference::State state = solver.download();
    const double share = std::clamp((step / 60.0 - 0.05) / 0.1, 0.0, 1.0);
    CAPTURE(step, share, state.displacement[31].transpose());
    CHECK((state.displacement[31] - share * motion.translate).norm() < 1e-8);
  }
}
