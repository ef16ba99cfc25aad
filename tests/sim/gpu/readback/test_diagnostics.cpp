// The solver's diagnostics of a state, against the same sums in double precision.
#include <catch2/catch.hpp>

#include "sim/gpu/solver.h"
#include "tests/support/gpu/bars.h"
#include "tests/support/gpu/gpu_fixture.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

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
  const State state = random_state(model, 0.004, 4);
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
  // A sum of terms of both signs: the rounding is that of its largest terms.
  double weights = 0;
  const std::vector<double> mass = consistent_masses(model);
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
  State lost = state;
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
  model.gravity.setZero();  // a load would affect the scale
  const SolverSettings settings;
  reference::NewtonSolver newton(model, settings);
  State state = random_state(model, 0.002, 12);
  const State before = state;
  newton.step(state);

  GpuSolver solver(gpu.programs, model, settings);
  const SimBuffers& buffers = solver.buffers();
  const auto residual_with = [&](const std::vector<Vector3d>& displacement) {
    // A step leaves the prediction of `before` in the buffers; then the displacement replaces its result.
    solver.upload(before);
    solver.step();
    State replaced = before;
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

TEST_CASE("diagnostics include all pairs of tets and all vertices, for any number of them", "[gpu]") {
  const auto loads = GENERATE(gl::LoadPath::texel, gl::LoadPath::storage);
  Gpu gpu(loads);
  for (const auto& [x, y, z] : {std::tuple(11, 8, 6), {12, 7, 5}, {12, 9, 7}, {17, 8, 8}}) {
    const Model model = make_model(make_box(x, y, z, {0.1 * x, 0.1 * y, 0.1 * z}), {1e5, 0.3, 1000},
                                   [](const Vector3d& at) { return at.x() < 1e-9; });
    GpuSolver solver(gpu.programs, model, {});
    const State state = random_state(model, 0.004, 4);
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
    CAPTURE(gl::name_of(loads), x, y, z, got->elastic, expected.elastic, got->reaction.transpose(),
            expected.fixed_reaction.transpose());
    CHECK(got->kinetic == Approx(expected.kinetic).epsilon(2e-6));
    CHECK(got->elastic == Approx(expected.elastic).epsilon(5e-6));
    CHECK((got->momentum - expected.momentum).norm() < 1e-5 * expected.momentum.norm());
    CHECK((got->reaction - expected.fixed_reaction).norm() < 1e-5 * expected.fixed_reaction.norm());
    CHECK(got->max_det_f == Approx(expected.max_det_f).epsilon(1e-5));
    CHECK(shown->largest == Approx(farthest).epsilon(1e-6));
  }
}

TEST_CASE("tets that are left out of the solve are included in the volume ratios, at their rest shape", "[gpu]") {
  Gpu gpu;
  const double held_up_to = GENERATE(0.05, 1.0);  // m: leaves out one layer of tets or all
  Model model =
      make_model(make_box(5, 4, 3, {0.1, 0.08, 0.06}), soft, [&](const Vector3d& x) { return x.y() < held_up_to; });
  State state = initial_state(model);
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
