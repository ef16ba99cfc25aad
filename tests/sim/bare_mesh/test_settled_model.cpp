#include "sim/bare_mesh/settled_model.h"

#include <catch2/catch.hpp>

#include "base/file.h"
#include "sim/bare_mesh/plan.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/reference/newton.h"
#include "tests/support/bare_shapes.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

struct MeshOnDisk {
  TemporaryFolder folder;
  std::filesystem::path path = folder / "cone.msh";
  MeshOnDisk() { write_mesh(path, turned(make_cone(50, 100), 2)); }  // z up, in mm
};

}  // namespace

TEST_CASE("a mesh on its own is settled, and its values are keys of the saved scene") {
  const MeshOnDisk mesh;
  Scene scene = open_scene(mesh.path);
  const Model model = settled_model(scene);
  CHECK(!scene.unsettled);
  REQUIRE(model.plan);
  const Body& body = scene.bodies[0];
  CHECK(body.unit == LengthUnit::mm);
  CHECK(body.up == UpAxis::z);
  CHECK(body.fixed == model.plan->fixed);
  CHECK(body.material.young_modulus == model.plan->young_modulus);
  REQUIRE(!model.notes.empty());
  CHECK(model.notes[0] == "cone: " + text_of(*model.plan));
  CHECK(!model.fixed.empty());
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : model.rest_positions) box.extend(p);
  CHECK(box.sizes().y() == Approx(0.1));
  for (const std::uint32_t v : model.fixed) CHECK(model.rest_positions[v].y() == Approx(box.min().y()));

  const std::filesystem::path saved = mesh.folder / "saved.json";
  write_file(saved, scene_to_json(scene, mesh.folder.path()));
  Scene again = open_scene(saved);
  CHECK(again.bodies == scene.bodies);
  CHECK(!again.unsettled);
  const Model same = settled_model(again);
  CHECK(!same.plan);
  CHECK(same.rest_positions == model.rest_positions);
  CHECK(same.fixed == model.fixed);
}

TEST_CASE("overrides settle single values of a mesh on its own") {
  const MeshOnDisk mesh;
  Scene scene = open_scene(mesh.path, {"unit=cm", "up=y", "materials.default.young_modulus=123"});
  const Model model = settled_model(scene);
  CHECK(scene.bodies[0].unit == LengthUnit::cm);
  CHECK(scene.bodies[0].up == UpAxis::y);
  CHECK(model.materials[0].young_modulus == 123);
  CHECK(!model.fixed.empty());
}

TEST_CASE("a method that does not carry the law of meshes on their own keeps one that it carries") {
  const MeshOnDisk mesh;
  Scene scene = open_scene(mesh.path, {"solver.method=jacobi"});
  const Model model = settled_model(scene);
  CHECK(carries(scene.solver.method, model.materials[0].model));
}

TEST_CASE("a mesh opened alone has the tissue law if the method carries it, and a note otherwise") {
  const MeshOnDisk mesh;
  const auto opened = [&](const std::vector<std::string>& overrides) {
    Scene scene = open_scene(mesh.path, overrides);
    const Model model = settled_model(scene);
    return std::pair(std::string(name_of(scene.bodies[0].material.model)), model.notes.back());
  };
  CHECK(opened({}).first == "squared");
  CHECK(opened({"materials.default.model=neo_hookean"}).first == "neo_hookean");
  const auto [law, note] = opened({"solver.method=jacobi"});
  CHECK(law == "signed_st_venant_kirchhoff");
  CHECK(note == "jacobi does not support the material model squared, so it is signed_st_venant_kirchhoff");
  Scene scene = open_scene(mesh.path);
  settled_model(scene);
  CHECK(scene_to_json(scene, mesh.folder.path()).find(R"("model": "squared")") != std::string::npos);
}

TEST_CASE("a rod that lies on a line of its flank does not roll off it") {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "rod.msh";
  const double radius = 0.01;
  TetMesh rod = make_cone(radius, 0.3, 1, 2, 40);
  for (Eigen::Vector3d& p : rod.positions)  // the lowest of its eight edges winds to both sides
    p = Eigen::AngleAxisd(0.23 * std::cos(40 * p.y()), Eigen::Vector3d::UnitY()) * p;
  write_mesh(path, turned(rod, 2));
  Scene scene = open_scene(path);
  const Model model = settled_model(scene);
  reference::NewtonSolver solver(model, scene.solver);
  State state = initial_state(model);
  for (int step = 0; step < 60; ++step) solver.step(state);
  double mass = 0;
  for (const double m : lumped_masses(model)) mass += m;
  const double sunk = -reference::measure(model, state).gravitational / (mass * scene.gravity.norm());
  CHECK(sunk < 0.1 * radius);
  CHECK(sunk > 0);
}
