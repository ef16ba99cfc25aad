// Surfaces filled with tets: well shaped for any surface, with its volume and topology; surfaces without an inside are
// refused.
// Covers: surface_fill, surface_repair, surface_report
#include "sim/surface/isosurface_stuffing.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "sim/mesh/mesh_check.h"
#include "sim/model/model.h"
#include "sim/surface/embedding.h"
#include "sim/surface/surface_fill.h"
#include "tests/support/surfaces.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

struct Filling {
  FilledSurface filled;
  MeshReport report;
  double spacing = 0;
};

/// Fills a surface and checks properties that hold for every surface.
Filling fill(const SurfaceMesh& surface, std::optional<int> resolution = {}) {
  Filling result{fill_surface(surface, "test.obj", resolution), {}, 0};
  const TetMesh& mesh = result.filled.file.mesh;
  const MeshRepair repaired = repair(mesh);
  result.report = examine(mesh, repaired);
  result.spacing = result.filled.repaired.report.box.sizes().maxCoeff() / result.filled.resolution;
  CHECK(repaired.flipped.empty());
  CHECK(repaired.degenerate.empty());
  CHECK(repaired.duplicated.empty());
  CHECK(result.report.slivers == 0);
  CHECK(result.report.smallest_dihedral_deg > kSmallestDihedral);
  CHECK(result.report.largest_dihedral_deg < kLargestDihedral);
  CHECK(result.report.unused_vertices == 0);
  return result;
}

/// The vertices of the tets' boundary lie on the surface and its facets have edges of at most 1.6 spacings (a long edge
/// and two shifts of 0.3), so between them the distance from a surface of curvature radius R is at most the sagitta
/// (1.6 h)^2 / (8 R): times the whole area this is the largest error of the volume.
double volume_tolerance(const Filling& f, double radius) {
  const double sagitta = std::pow(1.6 * f.spacing, 2) / (8 * radius);
  return f.filled.repaired.report.area * sagitta;
}

std::string error_of(const SurfaceMesh& surface) {
  try {
    fill_surface(surface, "test.obj", 10);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool has_note(const FilledSurface& filled, const std::string& part) {
  for (const std::string& note : filled.file.notes)
    if (note.find(part) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("spheres and tori are filled by one piece of their volume, with a boundary that follows them", "[lattice]") {
  const double radius = 0.04;
  for (const SurfaceMesh& surface : {test::make_sphere(24, 48, radius), test::make_torus(64, 32, 0.1, radius)}) {
    for (const int resolution : {8, 13, 20}) {
      const Filling f = fill(surface, resolution);
      CAPTURE(resolution, f.report.tet_count, f.report.volume, test::enclosed_volume(surface));
      CHECK(f.report.components == 1);
      CHECK(f.report.boundary_manifold);
      CHECK(std::abs(f.report.volume - test::enclosed_volume(surface)) < volume_tolerance(f, radius));
      const EmbeddedPoints drawn = embed(surface.positions, f.filled.file.mesh.positions, f.filled.file.mesh.tets);
      CHECK(drawn.farthest < 0.5 * f.spacing);
    }
  }
}

TEST_CASE("without a resolution a surface gets several thousand tets", "[lattice]") {
  for (const SurfaceMesh& surface :
       {test::make_sphere(24, 48, 0.05), test::make_torus(64, 32, 0.1, 0.04), test::make_box_surface({0.1, 0.1, 0.1}),
        test::make_box_surface({0.3, 0.05, 0.02})}) {
    const Filling f = fill(surface);
    CHECK(f.report.tet_count > 5000);
    CHECK(f.report.tet_count < 10000);
  }
}

TEST_CASE("the filling does not depend on the unit of the surface, and is the same every time", "[lattice]") {
  const SurfaceMesh surface = test::make_torus(40, 20, 0.1, 0.04);
  const TetMesh mesh = fill(surface, 12).filled.file.mesh;
  CHECK(mesh_hash(mesh) == mesh_hash(fill(surface, 12).filled.file.mesh));
  for (const double scale : {1e-6, 1e6}) {
    SurfaceMesh scaled = surface;
    for (Vector3d& p : scaled.positions) p *= scale;
    CHECK(fill(scaled, 12).filled.file.mesh.tets.size() == mesh.tets.size());
  }
}

TEST_CASE("a cube of 12 triangles is filled to its faces", "[lattice]") {
  const Filling f = fill(test::make_box_surface({0.1, 0.1, 0.1}), 10);
  CHECK(f.report.components == 1);
  // Only its edges are cut off: each by a prism of at most half a square spacing.
  CHECK(std::abs(f.report.volume - 1e-3) < 12 * 0.1 * 0.5 * f.spacing * f.spacing);
}

TEST_CASE("a plate thinner than the lattice stays in one piece, is covered and is noted", "[lattice]") {
  const SurfaceMesh plate = test::make_box_surface({0.2, 0.002, 0.1});
  const Filling f = fill(plate, 20);
  CHECK(f.report.components == 1);
  CHECK(has_note(f.filled, "thinner than the lattice"));
  const EmbeddedPoints drawn = embed(plate.positions, f.filled.file.mesh.positions, f.filled.file.mesh.tets);
  CHECK(drawn.farthest < 0.5 * f.spacing);
}

TEST_CASE("a thin vessel beside a thick body is noted, although it has hardly any volume", "[lattice]") {
  const SurfaceMesh ball = test::make_sphere(24, 48, 0.05);
  SurfaceMesh vessel = test::make_box_surface({0.001, 0.1, 0.001});
  for (Vector3d& p : vessel.positions) p.y() += 0.09;
  const Filling f = fill(test::joined(ball, vessel), 20);
  CHECK(f.report.volume == Approx(test::enclosed_volume(ball)).epsilon(0.02));
  CHECK(has_note(f.filled, "thinner than the lattice"));
}

TEST_CASE("a few tets kept whole in a thin tip do not cause a note", "[lattice]") {
  const Filling f = fill(read_obj(std::filesystem::path(FASCIA_SOURCE_DIR) / "assets/meshes/kidney.obj"), 24);
  CHECK_FALSE(has_note(f.filled, "thinner than the lattice"));
}

TEST_CASE("overlapping shells are one body, separate shells are several, an inverted shell in another one is a cavity",
          "[lattice]") {
  const SurfaceMesh ball = test::make_sphere(24, 48, 0.05), small = test::make_sphere(16, 32, 0.03);
  const double outer = test::enclosed_volume(ball), inner = test::enclosed_volume(small);

  const Filling overlapping = fill(test::joined(ball, test::make_sphere(24, 48, 0.05, {0.06, 0, 0})), 20);
  CHECK(overlapping.report.components == 1);
  CHECK(has_note(overlapping.filled, "the surface overlaps itself"));
  CHECK_FALSE(has_note(overlapping.filled, "thinner than the lattice"));
  // Two spheres at distance d share a lens of pi (4 R + d) (2 R - d)^2 / 12.
  const double lens = std::numbers::pi * (0.2 + 0.06) * std::pow(0.1 - 0.06, 2) / 12;
  CHECK(std::abs(overlapping.report.volume - (2 * outer - lens)) < volume_tolerance(overlapping, 0.05) + 0.02 * lens);

  CHECK(fill(test::joined(ball, test::make_sphere(24, 48, 0.05, {0.12, 0, 0})), 22).report.components == 2);

  for (const SurfaceMesh& hollow : {test::joined(ball, test::turned(small)), test::joined(test::turned(ball), small)}) {
    const Filling f = fill(hollow, 20);
    CHECK(f.filled.repaired.report.shells[1].cavity);
    CHECK(std::abs(f.report.volume - (outer - inner)) < volume_tolerance(f, 0.03));
  }
  const Filling nested = fill(test::joined(ball, small), 20);  // the same orientation: no cavity
  CHECK(std::abs(nested.report.volume - outer) < volume_tolerance(nested, 0.05));
}

TEST_CASE("inward normals, reversed or duplicated triangles, separate vertices and holes are repaired and noted",
          "[lattice]") {
  const SurfaceMesh ball = test::make_sphere(24, 48, 0.05);
  const TetMesh whole = fill(ball, 12).filled.file.mesh;

  const Filling inverted = fill(test::turned(ball), 12);
  CHECK(mesh_hash(inverted.filled.file.mesh) == mesh_hash(whole));
  CHECK(has_note(inverted.filled, "normals pointed inward"));
  CHECK(inverted.filled.surface.triangles == ball.triangles);  // drawn with outward normals

  SurfaceMesh mixed = ball;
  for (std::size_t t = 0; t < mixed.triangles.size(); t += 7) std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
  mixed.triangles.push_back(mixed.triangles[3]);
  mixed.triangles.push_back({5, 5, 6});
  const Filling repaired = fill(mixed, 12);
  CHECK(has_note(repaired.filled, "wound against the others"));
  CHECK(has_note(repaired.filled, "1 triangle at "));
  CHECK(repaired.filled.repaired.report.duplicates.count == 1);
  CHECK(repaired.filled.repaired.report.degenerate.count == 1);
  CHECK(repaired.report.tet_count == whole.tets.size());
  CHECK(repaired.filled.surface.triangles.size() == ball.triangles.size());  // drawn once each, outward
  CHECK(test::enclosed_volume(repaired.filled.surface) == Approx(test::enclosed_volume(ball)));
  CHECK(repaired.filled.surface.closed);

  SurfaceMesh soup;
  for (const Triangle& t : ball.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const std::uint32_t v : t) soup.positions.push_back(ball.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const Filling welded = fill(soup, 12);
  CHECK(welded.filled.repaired.closed());
  CHECK(welded.filled.repaired.report.shells.size() == 1);
  CHECK(mesh_hash(welded.filled.file.mesh) == mesh_hash(whole));

  SurfaceMesh holed = ball;
  holed.triangles.erase(holed.triangles.begin(), holed.triangles.begin() + 96);  // the top, 0.02 of the area
  const Filling closed = fill(holed, 12);
  CHECK(has_note(closed.filled, "1 hole of "));
  CHECK(closed.report.components == 1);
  CHECK_FALSE(closed.filled.surface.closed);
  // The hole is closed by a surface between the flat lid and the ball.
  CHECK(std::abs(closed.report.volume - test::enclosed_volume(ball)) <
        volume_tolerance(closed, 0.05) + 0.02 * test::enclosed_volume(ball));
}

TEST_CASE("the detected winding of an open shell does not depend on its position", "[lattice]") {
  const SurfaceMesh ball = test::make_sphere(24, 48, 0.05);
  for (const Vector3d& place :
       {Vector3d(1, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, -1, 0), Vector3d(0, 0, 1)}) {
    SurfaceMesh cup = test::make_sphere(16, 32, 0.02, place);
    cup.triangles.erase(cup.triangles.begin(), cup.triangles.begin() + 300);  // of 960, around a pole
    CAPTURE(place.transpose());
    CHECK_FALSE(repair(test::joined(ball, cup)).report.shells[1].inverted);
    CHECK(repair(test::joined(ball, test::turned(cup))).report.shells[1].inverted);
  }
}

TEST_CASE("a surface without an inside is refused with defect, number, place and advice", "[lattice]") {
  SurfaceMesh plane;
  plane.positions = {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0, 0.1}, {0, 0, 0.1}};
  plane.triangles = {{0, 1, 2}, {0, 2, 3}};
  CHECK(error_of(plane) ==
        "test.obj: is open: 4 edges, the first at (0.05, 0, 0) of one triangle only, 1 hole of 100 % of its area; "
        "expected a closed surface, or holes of at most 20 %: fill the holes in the program that made the file, or, "
        "where the surface is a thin wall, give that wall a thickness there");
  SurfaceMesh both_sides = test::joined(plane, test::turned(plane));
  CHECK(error_of(both_sides).find("is open") != std::string::npos);

  SurfaceMesh band;  // Moebius
  constexpr int kSteps = 12;
  for (int i = 0; i < kSteps; ++i) {
    const double a = 2 * std::numbers::pi * i / kSteps;
    for (const double w : {-0.02, 0.02})
      band.positions.emplace_back((0.1 + w * std::cos(a / 2)) * std::cos(a), w * std::sin(a / 2),
                                  (0.1 + w * std::cos(a / 2)) * std::sin(a));
  }
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * i + 1, c = i + 1 < kSteps ? 2 * i + 2 : 1,
                        d = i + 1 < kSteps ? 2 * i + 3 : 0;
    band.triangles.push_back({a, b, c});
    band.triangles.push_back({b, d, c});
  }
  CHECK(error_of(band).find("is one-sided") != std::string::npos);

  SurfaceMesh points;
  points.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  points.triangles = {{0, 1, 2}};
  CHECK(error_of(points).find("has no triangle with area") != std::string::npos);

  CHECK_THROWS_WITH(fill_surface(test::make_box_surface({1, 1, 1}), "test.obj", 256),
                    Catch::Contains("million tets; expected at most "));
}

TEST_CASE("self-intersecting surfaces are counted and filled", "[lattice]") {
  const SurfaceMesh two =
      test::joined(test::make_sphere(12, 24, 0.05), test::make_sphere(12, 24, 0.05, {0.05, 0.003, 0.001}));
  const SurfaceRepair repaired = repair(two);
  CHECK(self_intersections(TriangleTree(repaired.positions, repaired.triangles)).pairs.count > 20);
  const SurfaceRepair ball = repair(test::make_sphere(12, 24, 0.05));
  CHECK(self_intersections(TriangleTree(ball.positions, ball.triangles)).pairs.count == 0);
}
