// The cases of the stress suite as they are made: that each is what its name says, and can be simulated.
// Covers: case_maker, cases_conservation, cases_bodies, cases_contact, cases_handling, cases_meshes, cases_numbers
// Covers: cases_slender, cases_standing, cases_starts, cases_tangles
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <set>

#include "app/stress/case_maker.h"
#include "app/stress/stress.h"
#include "sim/grab/build_model.h"
#include "sim/material/tissues.h"
#include "sim/mesh/mesh_check.h"
#include "sim/reference/newton.h"
#include "tests/support/support.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

struct Suite {
  test::TemporaryFolder folder;
  std::vector<StressCase> cases;
  explicit Suite(const SolverChoice& pair = solver_choices().front(), ElementOrder elements = ElementOrder::linear)
      : cases(stress_cases(pair, MaterialModel::signed_st_venant_kirchhoff, Integrator::implicit_euler, elements,
                           folder.path(), true)) {}
  const StressCase& find(const std::string& group, const std::string& name) const {
    const auto found = std::find_if(cases.begin(), cases.end(),
                                    [&](const StressCase& c) { return c.group == group && c.name == name; });
    CAPTURE(group, name);
    REQUIRE(found != cases.end());
    return *found;
  }
  Model model_of(const std::string& group, const std::string& name) const {
    return build_model(find(group, name).replay.scene);
  }
  reference::Measures measure_start(const std::string& group, const std::string& name) const {
    return reference::measure(model_of(group, name), *find(group, name).replay.start);
  }
  bool has(const std::string& name) const {
    return std::any_of(cases.begin(), cases.end(), [&](const StressCase& c) { return c.name == name; });
  }
};

MeshReport report_of(const Model& model) { return examine(model.file_mesh, repair(model.file_mesh)); }

}  // namespace

TEST_CASE("every case of the stress suite has a unique name and can be simulated by its pair", "[cases]") {
  const SolverChoice pair =
      GENERATE(values<SolverChoice>({solver_choices().front(), {Method::jacobi, Acceleration::chebyshev}}));
  const Suite suite(pair);
  std::set<std::string> names;
  std::map<std::string, int> groups;
  for (const StressCase& c : suite.cases) {
    CAPTURE(c.group, c.name);
    CHECK(names.insert(c.group + "/" + c.name).second);
    ++groups[c.group];
    CHECK(c.replay.scene.solver.choice() == pair);
    CHECK(c.replay.steps > 0);
    CHECK(std::is_sorted(c.replay.inputs.begin(), c.replay.inputs.end(),
                         [](const Input& a, const Input& b) { return a.step < b.step; }));
    const Model model = build_model(c.replay.scene);
    CHECK(!model.tets.empty());
    if (c.criteria.creates_no_momentum) {  // no external forces
      CHECK(model.fixed.empty());
      CHECK(model.motions.empty());
      CHECK(model.gravity.isZero(0));
    }
    if (!c.replay.start) continue;
    REQUIRE(c.replay.start->displacement.size() == model.rest_positions.size());
    for (std::size_t v = 0; v < model.rest_positions.size(); ++v) {
      const Vector3d& u = c.replay.start->displacement[v];
      const Eigen::Vector3f stored = u.cast<float>();
      for (int k = 0; k < 3; ++k)
        if (!(u[k] == static_cast<double>(stored[k]))) {
          CAPTURE(v, k, u[k] - static_cast<double>(stored[k]));
          FAIL_CHECK("not a float32");
        }
    }
    for (const std::uint32_t v : model.fixed) CHECK(c.replay.start->displacement[v].norm() == 0);
  }
  CHECK(groups["start"] == 10);
  CHECK(groups["number"] == 20);
  CHECK(groups["conservation"] == 1);
  CHECK(groups["mesh"] == 8);
  CHECK(groups["handling"] == (pair == solver_choices().front() ? 9 : 8));
  const bool carries_tissue = carries(pair.method, kTissueLaw);  // the others have no such cases
  CHECK(groups["standing"] == (carries_tissue ? 24 : 0));
  CHECK(groups["contact"] == (info_of(pair.method).carries_contact ? 30 : 0));
  CHECK(groups["slender"] == (carries_tissue ? 4 : 0));
  CHECK(groups["tangles"] == (carries_tissue ? 12 : 0));
  CHECK(suite.has("method switched every frame") == (pair == solver_choices().front()));
}

TEST_CASE("with quadratic elements all bodies of the stress suite have them, and no method that does not carry them",
          "[cases]") {
  const Suite linear, suite(solver_choices().front(), ElementOrder::quadratic);
  REQUIRE(suite.cases.size() == linear.cases.size());
  for (const StressCase& c : suite.cases) {
    CAPTURE(c.group, c.name);
    for (const Body& body : c.replay.scene.bodies) CHECK(body.elements == ElementOrder::quadratic);
    const Model model = build_model(c.replay.scene);
    if (c.replay.start) REQUIRE(c.replay.start->displacement.size() == model.rest_positions.size());
    for (const Input& input : c.replay.inputs)
      if (const auto* solver = std::get_if<SolverSettings>(&input.change))
        CHECK(refusal(solver->method, model.materials, true, model.has_contact()) == "");
  }
  CHECK(can_run(Method::two_level, kTissueLaw, ElementOrder::quadratic));
  CHECK(!can_run(Method::gauss_seidel, Material().model, ElementOrder::quadratic));
  CHECK(can_run(Method::gauss_seidel, Material().model, ElementOrder::linear));
  CHECK(!can_run(Method::gauss_seidel, kTissueLaw, ElementOrder::linear));

  const Model tet = suite.model_of("mesh", "single tet");
  const State& shaken = *suite.find("mesh", "single tet").replay.start;
  REQUIRE(tet.rest_positions.size() == 10);
  for (const Vector3d& u : shaken.displacement) CHECK(u.norm() > 0);
}

TEST_CASE("a mesh of the stress suite keeps its name for itself", "[cases]") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "meshes");
  StressCases made{solver_choices().front(), kTissueLaw,    Integrator::implicit_euler,
                   ElementOrder::linear,     folder.path(), true};
  made.scene("beam", made.beam());
  made.scene("beam", made.beam());
  CHECK_THROWS_AS(made.scene("beam", made.beam(1)), std::logic_error);
}

TEST_CASE("starts of the stress suite have the disorder in their names", "[cases]") {
  const Suite suite;
  const auto tets = static_cast<int>(suite.model_of("start", "mirrored E=1e+06").tets.size());
  CHECK(suite.measure_start("start", "mirrored E=1e+06").inverted == tets);
  CHECK(suite.measure_start("start", "mirrored E=1e+06").max_det_f == Approx(-1));
  CHECK(suite.measure_start("start", "half mirrored E=1e+09").inverted == tets / 2);
  CHECK(suite.measure_start("start", "flattened E=1e+06").volume_ratio == Approx(0.125));  // the wedge at the clamp
  CHECK(suite.measure_start("start", "collapsed to a point E=1e+06").volume_ratio ==
        Approx(1.0 / 6));  // the pyramid at the clamp
  CHECK(suite.measure_start("start", "random E=1e+06").rms_strain > 1);
  CHECK(suite.find("start", "random E=1e+09").criteria.recovers);
  CHECK(suite.model_of("start", "random E=1e+09").materials[0].young_modulus == 1e9);
}

TEST_CASE("free bodies of the stress suite move, spin and are strained", "[cases]") {
  const Suite suite;
  const reference::Measures measures = suite.measure_start("conservation", "free and spinning");
  const double mass = 1000 * 0.4 * 0.2 * 0.2;
  const Vector3d middle = Vector3d(1, 2, 0.5) + Vector3d(3, -2, 5).cross(Vector3d(0.2, 0.1, 0.1));  // [m/s]
  CAPTURE(measures.momentum, measures.angular_momentum, measures.rms_strain);
  CHECK((measures.momentum - mass * middle).norm() < 0.05 * mass * middle.norm());
  CHECK(measures.angular_momentum.norm() > 0.1);
  CHECK(measures.rms_strain > 0.05);
  CHECK(suite.find("conservation", "free and spinning").criteria.creates_no_momentum);
}

TEST_CASE("meshes of the stress suite have the defects in their names", "[cases]") {
  const Suite suite;
  CHECK(suite.model_of("mesh", "single tet").tets.size() == 1);
  CHECK(suite.model_of("mesh", "two tets sharing an edge").tets.size() == 2);
  CHECK(report_of(suite.model_of("mesh", "two tets sharing an edge")).nonmanifold_edges == 1);
  const MeshReport needle = report_of(suite.model_of("mesh", "needle")), cap = report_of(suite.model_of("mesh", "cap"));
  CHECK(needle.longest_edge > 90 * needle.shortest_edge);
  CHECK(cap.slivers == 1);
  CHECK(report_of(suite.model_of("mesh", "slivers")).smallest_dihedral_deg == Approx(0.1).epsilon(0.5));
  CHECK(report_of(suite.model_of("mesh", "disconnected parts")).components == 3);
  CHECK(report_of(suite.model_of("mesh", "1 mm")).box_max.x() == Approx(1e-3));
  CHECK(report_of(suite.model_of("mesh", "100 m")).box_max.x() == Approx(100));
}

TEST_CASE("standing bodies of the stress suite weigh what their names say, on a clamped foot", "[cases]") {
  const Suite suite;
  for (const char* shape : {"cube", "cone"}) {
    const StressCase& made = suite.find("standing", std::string(shape) + " w=0.8 nu=0.49");
    const Model model = build_model(made.replay.scene);
    CAPTURE(shape);
    CHECK(model.materials[0].density * 9.81 * 0.4 / model.materials[0].young_modulus == Approx(0.8));
    CHECK(model.materials[0].poisson_ratio == 0.49);
    CHECK(model.fixed.size() == 16);  // of 4 x 4 x 4 vertices
    CHECK(report_of(model).box_max.y() == Approx(0.4));
    for (const std::uint32_t v : model.fixed) CHECK(model.rest_positions[v].y() < 1e-9);
    CHECK(made.criteria.carries_its_weight);
    CHECK(report_of(model).flipped == 0);
  }
}

TEST_CASE("three hands pull the trunk of the stress suite apart and let it go", "[cases]") {
  const Suite suite;
  const StressCase& made = suite.find("slender", "trunk with three hands");
  const Model model = build_model(made.replay.scene);
  CHECK(report_of(model).box_max.x() == Approx(0.15));
  std::set<double> pulls;
  const Input& last_pull = made.replay.inputs[made.replay.inputs.size() - 2];
  for (const GrabSpring& spring : std::get<GrabInput>(last_pull.change)) pulls.insert(spring.target.norm());
  CHECK(pulls.size() == 3);
  CHECK(std::get<GrabInput>(made.replay.inputs.back().change).empty());
  CHECK(made.criteria.springs_back);
}

TEST_CASE("numbers of the stress suite are those of their names", "[cases]") {
  const Suite suite;
  CHECK(suite.model_of("number", "E=1e+10").materials[0].young_modulus == 1e10);
  CHECK(suite.model_of("number", "nu=0.499").materials[0].poisson_ratio == 0.499);
  CHECK(suite.find("number", "h=1/250").replay.scene.solver.time_step == Approx(0.004));
  CHECK(suite.find("number", "iterations=100").replay.scene.solver.iterations == 100);
  const Model layers = suite.model_of("number", "layers of E 1:1e6");
  REQUIRE(layers.materials.size() == 2);
  CHECK(layers.materials[1].young_modulus == Approx(1e6 * layers.materials[0].young_modulus));
  const auto second = std::count(layers.tet_material.begin(), layers.tet_material.end(), 1u);
  CHECK(second == static_cast<std::ptrdiff_t>(layers.tets.size() / 2));
  const Model heavy = suite.model_of("number", "densities 1:1e4");
  CHECK(heavy.materials[1].density == Approx(1e4 * heavy.materials[0].density));
}

TEST_CASE("disturbances of the stress suite act in the first steps, and are then undone", "[cases]") {
  const Suite suite;
  for (const StressCase& c : suite.cases) {
    if (c.group != "handling" || c.name == "twisted by 720 degrees") continue;
    CAPTURE(c.name);
    CHECK(c.criteria.recovers);
    REQUIRE(c.replay.inputs.size() >= 84);
    const auto& inputs = c.replay.inputs;
    CHECK(inputs[inputs.size() - 5].step == 79);
    CHECK(inputs.back() == Input{80, GrabInput{}});
    CHECK(inputs[inputs.size() - 4] == Input{80, c.replay.scene.solver});
    CHECK(c.replay.steps == 240);
  }
  const auto& pull = std::get<GrabInput>(suite.find("handling", "grab pulled 10 sizes away").replay.inputs[79].change);
  REQUIRE(!pull.empty());
  CHECK(pull.front().target.norm() == Approx(10 * Vector3d(0.4, 0.2, 0.2).norm()));
  const Model twisted = suite.model_of("handling", "twisted by 720 degrees");
  REQUIRE(twisted.motions.size() == 1);
  CHECK(twisted.motions[0].angle == Approx(4 * 3.14159265358979));
}
