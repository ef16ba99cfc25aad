// The shipped meshes are valid and have the sizes in assets/README.md; the shipped scenes open and support their
// bodies.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "sim/grab/build_model.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_check.h"
#include "sim/model/model.h"
#include "sim/scene/scene.h"
#include "tests/support/support.h"

using namespace fascia;
namespace fs = std::filesystem;

namespace {

fs::path assets() { return test::source_dir() / "assets"; }

std::size_t count_files(const fs::path& folder, const std::string& ending) {
  return static_cast<std::size_t>(
      std::count_if(fs::directory_iterator(folder), fs::directory_iterator(),
                    [&](const fs::directory_entry& entry) { return entry.path().extension() == ending; }));
}

struct ShippedMesh {
  std::string name;
  std::size_t least_tets, most_tets;
  double width;                     // [m] largest extent, to 10 %
  std::vector<std::string> groups;  // that scenes may select
};

const std::vector<ShippedMesh> kMeshes = {
    {"beam", 4750, 5250, 0.4, {"tissue", "clamp"}},
    {"ligament", 6750, 7250, 0.135, {"ligament", "clamp_left", "clamp_right"}},
    {"liver", 9500, 10500, 0.25, {"liver"}},
    {"inclusion", 5000, 6000, 0.16, {"tissue", "tumour", "clamp"}},
    {"cube", 490, 510, 0.1, {"tissue", "clamp"}},
};

}  // namespace

TEST_CASE("shipped meshes are valid") {
  CHECK(count_files(assets() / "meshes", ".msh") == kMeshes.size());
  for (const ShippedMesh& shipped : kMeshes) {
    CAPTURE(shipped.name);
    const fs::path path = assets() / "meshes" / (shipped.name + ".msh");
    CHECK(fs::file_size(path) < 600000);  // the repository contains them
    const MeshFile file = read_mesh(path);
    const MeshReport report = examine(file.mesh, repair(file.mesh));
    CHECK(report.usable_tets == report.tet_count);
    CHECK(report.tet_count >= shipped.least_tets);
    CHECK(report.tet_count <= shipped.most_tets);
    CHECK(report.flipped == 0);
    CHECK(report.unused_vertices == 0);
    CHECK(report.components == 1);
    CHECK(report.boundary_manifold);
    CHECK(report.smallest_dihedral_deg > 12);
    CHECK((report.box_max - report.box_min).maxCoeff() == Approx(shipped.width).epsilon(0.1));
    CHECK(report.unit_guess.empty());
    for (const std::string& group : shipped.groups) {
      CAPTURE(group);
      REQUIRE(file.mesh.groups.count(group) == 1);
      CHECK_FALSE(file.mesh.groups.at(group).empty());
    }
  }
}

TEST_CASE("shipped scenes open, fix a small part of their body and place a camera") {
  CHECK(count_files(assets() / "scenes", ".json") >= kMeshes.size());
  for (const ShippedMesh& shipped : kMeshes) CHECK(fs::exists(assets() / "scenes" / (shipped.name + ".json")));
  for (const fs::directory_entry& entry : fs::directory_iterator(assets() / "scenes")) {
    CAPTURE(entry.path());
    const Scene scene = open_scene(entry.path());
    CHECK_FALSE(scene.title.empty());
    CHECK(scene.camera.has_value());
    const Model model = build_model(scene);
    std::size_t held = model.fixed.size();
    for (const Motion& motion : model.motions) held += motion.vertices.size();
    CHECK((held >= 10 || scene.tools.ground));  // lies on the ground
    CHECK(model.fixed.size() < model.rest_positions.size() / 4);
  }
}

TEST_CASE("the inclusion is a hundred times as stiff as the tissue around it") {
  const Model model = build_model(open_scene(assets() / "scenes" / "inclusion.json"));
  REQUIRE(model.materials.size() == 2);
  const double first = model.materials[0].young_modulus, second = model.materials[1].young_modulus;
  CAPTURE(first, second);
  CHECK(std::max(first / second, second / first) == Approx(100));
}
