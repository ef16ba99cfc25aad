// Covers: shapes
#include "app/bench/fill/fill.h"

#include <catch2/catch.hpp>
#include <set>

#include "sim/surface/isosurface_stuffing.h"
#include "sim/surface/surface_repair.h"

using namespace fascia;

TEST_CASE("twenty closed shapes of different names enclose volumes") {
  const std::vector<Shape> shapes = fill_shapes();
  CHECK(shapes.size() == 20);
  std::set<std::string> names;
  for (const Shape& shape : shapes) {
    CAPTURE(shape.name);
    names.insert(shape.name);
    const SurfaceRepair repaired = repair(shape.surface);
    CHECK(repaired.closed());
    CHECK(repaired.balanced);
    CHECK(repaired.report.volume > 0);
    CHECK(repaired.report.box.sizes().maxCoeff() == Approx(0.2).epsilon(0.2));
  }
  CHECK(names.size() == shapes.size());
}

TEST_CASE("the angles of every filling are bounded, no part is lost, and organs keep their volume") {
  constexpr std::size_t kOrgans = 6;  // the first shapes: smooth, and thicker than the lattice
  const std::vector<Shape> shapes = fill_shapes();
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    CAPTURE(shapes[s].name);
    const FillQuality q = fill_quality(shapes[s], 16);
    INFO(q.tets << " tets, " << q.volume_error << " of the volume, " << q.spacings << " spacings");
    CHECK(q.resolution == 16);
    CHECK(q.smallest_dihedral_deg > kSmallestDihedral);
    CHECK(q.largest_dihedral_deg < kLargestDihedral);
    CHECK(q.spacings < 1.5);  // a tet that is kept whole where the surface is thin is one spacing long
    if (s < kOrgans) CHECK(std::abs(q.volume_error) < 0.02);
  }
}

TEST_CASE("a finer lattice is nearer to a smooth surface") {
  const std::vector<Shape> shapes = fill_shapes();
  const FillQuality coarse = fill_quality(shapes[0], 10), fine = fill_quality(shapes[0], 20);
  CHECK(fine.distance < 0.5 * coarse.distance);
  CHECK(std::abs(fine.volume_error) < 0.5 * std::abs(coarse.volume_error));
}

TEST_CASE("thin parts are reported with a resolution that resolves them") {
  for (const Shape& shape : fill_shapes()) {
    if (shape.name != "spaghetti") continue;
    const FillQuality q = fill_quality(shape, 16);
    REQUIRE(q.notes.size() == 2);
    CHECK_THAT(q.notes[0], Catch::StartsWith("the surface overlaps itself"));  // the tube crosses itself
    CHECK_THAT(q.notes[1], Catch::Contains("thinner than the lattice's") && Catch::Contains("--set resolution="));
  }
}

TEST_CASE("the table has a row per shape and resolution") {
  const Table table = fill_table(true);
  CHECK(table.rows.size() == 20);
  for (const auto& row : table.rows) CHECK(row.size() == table.columns.size());
}
