// The axis of fascia bench accuracy that has the continuum as its truth, on tiny beams.
#include "app/bench/accuracy/continuum.h"

#include <catch2/catch.hpp>

#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("bench accuracy compares elements, integrators and meshes with the continuum", "[bench]") {
  const TemporaryFolder folder;
  BenchOptions options;
  options.out = folder.path().string();
  options.context = "osmesa";
  options.quiet = true;
  Bench bench(options, "accuracy");
  const ContinuumGrid grid{{8}, {4}, {10}, {0.3}, 8, 4};
  const std::vector<ContinuumPoint> points = bench_continuum(bench, grid);
  REQUIRE(points.size() == 6);
  const auto find = [&](ElementOrder elements, Integrator integrator) {
    for (const ContinuumPoint& point : points)
      if (point.choice.elements == elements && point.choice.integrator == integrator) return point;
    FAIL("not measured");
    return points.front();
  };
  const ContinuumPoint linear = find(ElementOrder::linear, Integrator::implicit_euler),
                       quadratic = find(ElementOrder::quadratic, Integrator::bdf2),
                       damped = find(ElementOrder::quadratic, Integrator::implicit_euler);
  CAPTURE(linear.error, quadratic.error, damped.error);
  CHECK(linear.vertices == 81);
  CHECK(quadratic.vertices == 81);
  CHECK(linear.tets == 192);
  CHECK(quadratic.tets == 24);
  CHECK(quadratic.error < damped.error);
  CHECK(damped.error < linear.error);
  for (const ContinuumPoint& point : points) CHECK(point.ms > 0);
  const std::string table = read_file(folder / "continuum.csv"), summary = read_file(folder / "continuum.md"),
                    tips = read_file(folder / "continuum_static.csv");
  CHECK(table.find("elements,vertices,tets,poisson_ratio,integrator,iterations,error,ms_median") != std::string::npos);
  CHECK(table.find("quadratic,81,24,0.3,bdf2,10,") != std::string::npos);
  CHECK(summary.find("| quadratic, bdf2 |") != std::string::npos);
  CHECK(tips.find("linear,81,192,0.3,") != std::string::npos);
  CHECK(summary.find("nu = 0.3: 24 quadratic tets with half the substeps are ") != std::string::npos);
}

TEST_CASE("the grids of the continuum compare equal numbers of vertices") {
  for (const bool quick : {false, true}) {
    const ContinuumGrid grid = continuum_grid(quick);
    for (const int cells : grid.linear_cells) CHECK(cells % 4 == 0);
    for (const int cells : grid.quadratic_cells) {
      CHECK(cells % 4 == 0);
      CHECK(cells < grid.truth_cells);
    }
    CHECK(grid.choices().size() ==
          3 * grid.iterations.size() * (grid.linear_cells.size() + grid.quadratic_cells.size()));
  }
}
