// Expensive surfaces: many shells, many triangles at one edge or vertex, long thin triangles. The tests count the work.
// Covers: lattice_sides, surface_shells
#include <catch2/catch.hpp>
#include <cstdio>
#include <random>

#include "base/error.h"
#include "sim/surface/lattice_sides.h"
#include "sim/surface/surface_fill.h"
#include "sim/surface/surface_shells.h"
#include "tests/support/surfaces.h"

using namespace fascia;
using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

enum class Inner { once, twice, twice_across };

/// The faces of n x n x n cubes as quads of two triangles each: those between two cubes once, or twice with opposite
/// windings, with the same diagonal or the other one.
SurfaceMesh faces_of_cubes(int n, Inner inner) {
  SurfaceMesh s;
  const auto at = [&](const Vector3i& p) {
    return static_cast<std::uint32_t>((p.x() * (n + 1) + p.y()) * (n + 1) + p.z());
  };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k) s.positions.push_back(0.1 / n * Vector3d(i, j, k));
  const auto add = [&](const Vector3i& cube, int axis, bool far) {
    const Vector3i u = Vector3i::Unit((axis + 1) % 3), v = Vector3i::Unit((axis + 2) % 3),
                   a = cube + int{far} * Vector3i::Unit(axis);
    if (inner == Inner::once && far && a[axis] < n) return;
    std::array<std::uint32_t, 4> quad{at(a), at(a + u), at(a + u + v), at(a + v)};
    if (!far) std::swap(quad[1], quad[3]);
    if (inner == Inner::twice_across && far) std::rotate(quad.begin(), quad.begin() + 1, quad.end());
    s.triangles.push_back({quad[0], quad[1], quad[2]});
    s.triangles.push_back({quad[0], quad[2], quad[3]});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        for (int axis = 0; axis < 3; ++axis)
          for (const bool far : {false, true}) add({i, j, k}, axis, far);
  return s;
}

/// A cone of n triangles around its tip, closed by n around the middle of its base.
SurfaceMesh make_cone(std::uint32_t n) {
  SurfaceMesh s;
  s.positions = {{0, 0.1, 0}, {0, 0, 0}};
  for (std::uint32_t i = 0; i < n; ++i)
    s.positions.emplace_back(0.1 * std::cos(2 * std::numbers::pi * i / n), 0,
                             0.1 * std::sin(2 * std::numbers::pi * i / n));
  for (std::uint32_t i = 0; i < n; ++i) {
    s.triangles.push_back({0, 2 + (i + 1) % n, 2 + i});
    s.triangles.push_back({1, 2 + i, 2 + (i + 1) % n});
  }
  return s;
}

std::size_t reports_of(const SurfaceMesh& surface, int resolution) {
  std::size_t count = 0;
  double last = 0;
  bool ascends = true;
  fill_surface(surface, "test.obj", resolution, [&](double share, const char*) {
    ++count;
    ascends = ascends && share >= last && share <= 1;
    last = share;
  });
  CHECK(ascends);
  return count;
}

}  // namespace

TEST_CASE("of many shells only those are compared whose boxes enclose each other, the largest first", "[surface]") {
  constexpr std::uint32_t kCount = 50000;
  std::vector<ShellTree::Shell> apart, nested;
  for (std::uint32_t s = 0; s < kCount; ++s) {
    const Vector3d corner(s % 50, s / 50 % 50, s / 2500);
    apart.push_back({{corner, corner + Vector3d::Constant(1 + 1e-9 * s)}, 1 + 1e-9 * s, s});
    const Vector3d half = Vector3d::Constant(1 + s);
    nested.push_back({{-half, half}, 1.0 + s, s});
  }
  std::size_t asked = 0, found = 0;
  const ShellTree tree_apart(apart), tree_nested(nested);
  for (const ShellTree::Shell& shell : apart)
    tree_apart.largest_around(shell.box, shell.area, [&](std::uint32_t) { return ++asked > 0; });
  std::printf("%u shells apart: %zu compared\n", kCount, asked);
  CHECK(asked == 0);
  for (const ShellTree::Shell& shell : nested)
    found +=
        tree_nested.largest_around(shell.box, shell.area, [&](std::uint32_t) { return ++asked > 0; }) == kCount - 1;
  std::printf("%u shells, one within the other: %zu compared\n", kCount, asked);
  CHECK(asked == kCount - 1);
  CHECK(found == kCount - 1);
}

TEST_CASE("the enclosing shell is the one that a comparison of all finds", "[surface]") {
  std::mt19937 random(1);
  const auto unit = [&] { return static_cast<double>(random() % 1000) / 1000; };
  std::vector<ShellTree::Shell> shells;
  for (std::uint32_t s = 0; s < 400; ++s) {
    const Vector3d low(unit(), unit(), unit()), size(unit(), unit(), unit());
    shells.push_back({{low, low + size * size.x()}, std::floor(20 * size.squaredNorm()), s});
  }
  const ShellTree tree(shells);
  const auto holds = [](std::uint32_t outer, std::uint32_t inner) { return (outer * 7 + inner) % 3 == 0; };
  std::size_t held = 0;
  for (const ShellTree::Shell& inner : shells) {
    std::uint32_t expected = ShellTree::kNone;
    double largest = inner.area;
    for (const ShellTree::Shell& outer : shells) {
      if (!(outer.area > largest) || !outer.box.contains(inner.box) || !holds(outer.number, inner.number)) continue;
      expected = outer.number;
      largest = outer.area;
    }
    CHECK(tree.largest_around(inner.box, inner.area, [&](std::uint32_t outer) { return holds(outer, inner.number); }) ==
          expected);
    held += expected != ShellTree::kNone;
  }
  std::printf("%zu of %zu shells lie in another one\n", held, shells.size());
  CHECK(held > 50);
}

TEST_CASE("the faces of all cells of a grid are tens of thousands of shells, with progress reports", "[surface]") {
  const SurfaceMesh faces = faces_of_cubes(20, Inner::once);
  std::size_t reports = 0;
  const SurfaceRepair repaired = repair(faces, [&](double, const char*) { ++reports; });
  std::printf("%zu triangles: %zu shells, %zu edges of several triangles, %zu reports\n", faces.triangles.size(),
              repaired.report.shells.size(), repaired.report.crowded_edges.count, reports);
  CHECK(repaired.closed());
  CHECK_FALSE(repaired.balanced);
  CHECK(repaired.report.shells.size() > 20000);
  CHECK(reports > repaired.report.shells.size() / 100);
  CHECK_THROWS_WITH(fill_surface(faces, "test.obj", 10),
                    Catch::Contains("test.obj: has walls inside: ") && Catch::Contains("of more than two triangles"));

  CHECK(repair(test::make_sphere(12, 24, 0.05)).balanced);
  SurfaceMesh two = test::make_box_surface({1, 1, 1}), other = two;  // they share an edge
  for (Vector3d& x : other.positions) x += Vector3d(1, 1, 0);
  const SurfaceRepair joined = repair(test::joined(two, other));
  CHECK(joined.report.crowded_edges.count == 1);
  CHECK(joined.balanced);
  CHECK(joined.report.volume == Approx(2));
}

TEST_CASE("cells with all their faces are filled as one body", "[surface]") {
  for (const Inner inner : {Inner::twice, Inner::twice_across}) {
    const SurfaceMesh faces = faces_of_cubes(12, inner);
    const FilledSurface filled = fill_surface(faces, "test.obj", 14);
    double volume = 0;
    const auto& x = filled.file.mesh.positions;
    for (const Tet& t : filled.file.mesh.tets) volume += signed_volume6(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) / 6;
    const SurfaceReport& report = filled.repaired.report;
    std::printf("%zu triangles: %zu walls left out, volume %g, of the tets %g\n", faces.triangles.size(),
                report.walls.count, report.volume, volume);
    CHECK(report.volume == Approx(1e-3));
    CHECK(volume == Approx(1e-3).epsilon(0.03));  // the edges of the cube are cut off
    CHECK(report.walls.count == (inner == Inner::twice ? 4u * 3 * 12 * 12 * 11 : 0u));
  }
  // Drawn from both sides it is one ball, as before.
  const SurfaceMesh ball = test::make_sphere(12, 24, 0.05);
  const SurfaceRepair both = repair(test::joined(ball, test::turned(ball)));
  CHECK(both.report.duplicates.count == ball.triangles.size());
  CHECK(both.report.volume == Approx(test::enclosed_volume(ball)));
}

TEST_CASE("a progress callback that throws ends the work on a surface at any point", "[surface]") {
  struct Enough {};
  const SurfaceMesh surface = faces_of_cubes(6, Inner::twice_across);
  std::size_t all = 0;
  fill_surface(surface, "test.obj", 6, [&](double, const char*) { ++all; });
  std::size_t ended = 0;
  for (std::size_t stop = 1; stop <= all; ++stop) {
    std::size_t count = 0;
    CHECK_THROWS_AS(fill_surface(surface, "test.obj", 6,
                                 [&](double, const char*) {
                                   if (++count == stop) throw Enough();
                                 }),
                    Enough);
    ended += count == stop;
  }
  std::printf("%zu reports, ended at %zu of them\n", all, ended);
  CHECK(all > 40);
  CHECK(ended == all);
}

TEST_CASE("long thin triangles are sampled only along their length, with progress reports while all are tested",
          "[surface]") {
  const SurfaceMesh cone = make_cone(2000);
  const FilledSurface filled = fill_surface(cone, "test.obj", 16);
  double volume = 0;
  const auto& x = filled.file.mesh.positions;
  for (const Tet& t : filled.file.mesh.tets) volume += signed_volume6(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) / 6;
  const std::size_t reports = reports_of(cone, 16);
  std::printf("cone of %zu triangles: %zu tets, volume %g of %g, %zu reports\n", cone.triangles.size(),
              filled.file.mesh.tets.size(), volume, test::enclosed_volume(cone), reports);
  CHECK(volume == Approx(test::enclosed_volume(cone)).epsilon(0.06));  // its sharp edge is thinner than the lattice
  CHECK(reports > 100);
}

TEST_CASE("a long triangle reaches the cells along it, not its whole box", "[surface]") {
  std::vector<Vector3d> corners = {{0, 0, 0}, {1, 1, 1}, {1, 1, 0.999}};
  const TriangleTree sliver(corners, {{0, 1, 2}});
  const BccLattice lattice(sliver.box(), 60);
  const std::vector<char> reached = cells_at_surface(sliver, lattice);
  const auto count = static_cast<std::size_t>(std::count(reached.begin(), reached.end(), 1));
  std::printf("%zu of %u cells\n", count, lattice.cell_count());
  CHECK(count < 8 * 60);
  std::mt19937 random(2);
  const auto unit = [&] { return static_cast<double>(random() % 100000) / 100000; };
  std::size_t missed = 0;
  for (int t = 0; t < 200; ++t) {
    const std::vector<Vector3d> x = {
        {unit(), unit(), unit()}, {unit(), unit(), unit()}, {unit(), unit(), unit()}, {0, 0, 0}, {1, 1, 1}};
    const TriangleTree tree(x, {{0, 1, 2}, {3, 3, 4}});  // and its box
    const std::vector<char> marked = cells_at_surface(tree, lattice);
    for (int i = 0; i < 500; ++i) {
      double a = unit(), b = unit();
      if (a + b > 1) a = 1 - a, b = 1 - b;
      missed += !marked[lattice.cell(lattice.cell_at(x[0] + a * (x[1] - x[0]) + b * (x[2] - x[0])))];
    }
  }
  std::printf("100000 points of triangles: %zu in cells that are not marked\n", missed);
  CHECK(missed == 0);
}

TEST_CASE("a library of materials is read once for any number of references, and missing items are named a few times",
          "[surface]") {
  std::string text, triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 20000; ++i)
    text += "mtllib a.mtl\nmtllib none" + std::to_string(i) + ".mtl\nusemtl m" + std::to_string(i) + "\nf 1 2 3\n";
  std::size_t asked = 0;
  const SurfaceMesh mesh = read_obj_content("a.obj", triangle + text, [&](const std::string& name) -> std::string {
    ++asked;
    if (name == "a.mtl") return "newmtl m7\nKd 1 0 0\n";
    throw Error(name, "does not exist", "");
  });
  std::printf("%zu materials, libraries asked for %zu times, %zu notes\n", mesh.materials.size(), asked,
              mesh.notes.size());
  CHECK(asked == 20001);
  CHECK(mesh.materials.size() == 20000);
  CHECK(mesh.materials[0].name == "m7");
  CHECK(mesh.materials[0].color == 0xff0000ff);
  CHECK(mesh.notes.size() == 9);
  CHECK(mesh.notes.back() == "19992 more libraries of materials are missing");
}

TEST_CASE("a seam whose vertices differ by rounding is no hole in the notes", "[surface]") {
  const auto notes_with = [](double gap) {
    SurfaceMesh box = test::make_box_surface({0.1, 0.2, 0.3});
    const std::uint32_t corner = box.triangles[0][0];
    box.positions.push_back(box.positions[corner] + Eigen::Vector3d(gap, 0, 0));
    box.triangles[0][0] = static_cast<std::uint32_t>(box.positions.size() - 1);
    return notes_of(repair(box).report);
  };
  const std::vector<std::string> seam = notes_with(1e-15), hole = notes_with(0.02);
  REQUIRE(seam.size() == 1);
  CHECK_THAT(seam[0], Catch::Contains("along a seam without width"));
  REQUIRE(hole.size() == 1);
  CHECK_THAT(hole[0], Catch::Contains(" of the area ("));
}
