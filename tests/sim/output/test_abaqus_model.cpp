// A model as an Abaqus file: read back, and solved by CalculiX where it is installed.
#include "sim/output/abaqus_model.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>

#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/output/state_export.h"
#include "sim/reference/newton.h"
#include "tests/sim/reference/box_model.h"
#include "tests/sim/reference/calculix_cube.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

namespace {

bool has_calculix() {
  if (std::system("command -v ccx >/dev/null") == 0) return true;
  WARN("ccx is not installed");
  return false;
}

struct CalculixResult {
  std::map<std::size_t, Vector3d> moved;  // by node, from 1 [m]
  std::vector<double> totals;             // [J]
};

/// Runs ccx in a folder of its own on `text` and the set Nall of all vertices.
CalculixResult run_calculix(const Model& model, const std::string& text) {
  const TemporaryFolder folder;
  std::ofstream(folder / "model.inp") << std::setprecision(12)
                                      << abaqus_model_text(model, std::vector<Vector3d>(model.rest_positions.size(),
                                                                                        Vector3d::Zero()))
                                      << "*NSET, NSET=Nall, GENERATE\n1, " << model.rest_positions.size() << text;
  REQUIRE(std::system(("cd '" + folder.path().string() + "' && ccx model >ccx.log 2>&1").c_str()) == 0);
  CalculixResult result;
  std::istringstream lines(read_file(folder / "model.dat"));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers(line), alone(line);
    std::size_t node;
    double total;
    std::string more;
    Vector3d u;
    if (numbers >> node >> u.x() >> u.y() >> u.z())
      result.moved[node] = u;
    else if (alone >> total && !(alone >> more))
      result.totals.push_back(total);
  }
  return result;
}

/// A bar held at x = 0, linear or quadratic, of two materials without lateral contraction: then quadratic tets are
/// C3D10, whose pressure is not averaged.
Model bar(bool ten_nodes) {
  Material material = soft(1e6, 0);
  material.model = MaterialModel::st_venant_kirchhoff;
  Model model = box_model(6, 2, 2, {0.6, 0.2, 0.2}, material, [](const Vector3d& x) { return x.x() == 0; });
  if (ten_nodes) model = quadratic(model);
  material.young_modulus = 3e6;
  model.materials.push_back(material);
  model.material_names = {"bar: soft", "bar: hard"};
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    double x = 0;
    for (const std::uint32_t v : model.tets[t]) x += model.rest_positions[v].x() / 4;
    model.tet_material[t] = x < 0.3 ? 0 : 1;
  }
  model.gravity = {0, -0.5, 0};
  return model;
}

}  // namespace

TEST_CASE("a model as .inp has its shape, materials as regions, and its fixed vertices", "[export]") {
  const bool ten_nodes = GENERATE(false, true);
  const Model model = bar(ten_nodes);
  State state = initial_state(model);
  for (std::size_t v = 0; v < state.displacement.size(); ++v)
    state.displacement[v] = 0.1 * Vector3d(model.rest_positions[v].y(), 0, 0);
  const TemporaryFolder folder;
  const Provenance provenance{{"Software", "fascia"}, {"Parameters", std::string(2000, 'p')}};
  write_state(folder / "bar.inp", model, reference::export_fields(model, state), provenance);
  const MeshFile back = read_mesh(folder / "bar.inp");
  REQUIRE(back.mesh.positions.size() == model.rest_positions.size());
  double largest = 0;
  for (std::size_t v = 0; v < back.mesh.positions.size(); ++v)
    largest = std::max(largest, (back.mesh.positions[v] - model.rest_positions[v] - state.displacement[v]).norm());
  CHECK(largest < 1e-12);
  CHECK(back.mesh.tets == model.tets);
  CHECK(back.mid_edges == model.mid_edges);
  CHECK(back.mesh.region_names == std::map<int, std::string>{{1, "bar__soft"}, {2, "bar__hard"}});
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    REQUIRE(back.mesh.regions[t] == static_cast<int>(model.tet_material[t]) + 1);
  CHECK(back.mesh.groups.at("fixed") == model.fixed);
  CHECK(find_provenance(read_file(folder / "bar.inp")) == provenance);
  CHECK(read_file(folder / "bar.inp").find("*ELASTIC\n3e+06, 0\n*DENSITY\n") != std::string::npos);
}

TEST_CASE("CalculiX bends an exported bar by its weight as the reference solver does", "[export]") {
  if (!has_calculix()) return;
  const bool ten_nodes = GENERATE(false, true);
  const Model model = bar(ten_nodes);
  State state = initial_state(model);
  std::ostringstream step;
  step << std::setprecision(12) << "\n*STEP, NLGEOM\n*STATIC\n*CLOAD\n";
  const std::vector<double> mass = consistent_masses(model);
  for (std::size_t v = 0; v < mass.size(); ++v) step << v + 1 << ", 2, " << mass[v] * model.gravity.y() << '\n';
  step << "*NODE PRINT, NSET=Nall\nU\n*END STEP\n";
  const std::map<std::size_t, Vector3d> moved = run_calculix(model, step.str()).moved;
  REQUIRE(moved.size() == model.rest_positions.size());
  REQUIRE(reference::NewtonSolver(model, {}).solve_static(state).converged);
  double squared = 0, whole = 0;
  for (const auto& [node, u] : moved) {
    squared += (state.displacement[node - 1] - u).squaredNorm();
    whole += u.squaredNorm();
  }
  CAPTURE(ten_nodes, whole);
  CHECK(whole > 0);
  CHECK(std::sqrt(squared / whole) < 1e-4);
}

TEST_CASE("the stored results of CalculiX for a cube are those of the exported cube", "[export]") {
  if (!has_calculix()) return;
  const CalculixCube& cube = kCalculixCubes[GENERATE(0u, 2u, 4u)];  // the finer ones take ccx four seconds each
  const Model model = displaced_cube(cube.cells, cube.nu);
  std::ostringstream step;
  step << std::setprecision(12) << "\n*STEP, NLGEOM\n*STATIC\n*BOUNDARY\n";
  for (const std::uint32_t v : model.motions[0].vertices)
    for (int k = 1; k <= 3; ++k)
      step << v + 1 << ", " << k << ", " << k << ", " << on_cube_surface(model.rest_positions[v])[k - 1] << '\n';
  step << "*NODE PRINT, NSET=Nall\nU\n*EL PRINT, ELSET=cube, TOTALS=ONLY\nELSE\n*END STEP\n";
  const CalculixResult result = run_calculix(model, step.str());
  REQUIRE(result.totals.size() == 1);
  CHECK(result.totals[0] == Approx(cube.energy).epsilon(1e-6));
  for (std::size_t place = 0; place < kCalculixPlaces.size(); ++place)
    for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
      if ((model.rest_positions[v] - kCalculixPlaces[place]).norm() < 1e-9)
        CHECK((result.moved.at(v + 1) - cube.displacement[place]).norm() < 2e-8);
}
