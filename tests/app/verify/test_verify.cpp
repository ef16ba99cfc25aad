// The report of fascia verify and its bodies; tests/app/commands/test_verify.cpp runs the tests.
// Covers: cantilever, column, cook, estimates, gpu, motion_estimates, orders, patches, solids, stresses
// Covers: time_estimates, verification
#include <catch2/catch.hpp>
#include <cmath>

#include "app/verify/solids.h"
#include "app/verify/verification.h"
#include "base/file.h"
#include "sim/mesh/mesh_generate.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("a number passes within its range, and what is not a number does not", "[verify]") {
  VerifiedNumber number{"test", "case", "m", 1, 0.5, 1.5, "truth"};
  CHECK(number.passed());
  number.value = 2;
  CHECK_FALSE(number.passed());
  number.value = std::nan("");
  CHECK_FALSE(number.passed());
}

TEST_CASE("a failed number fails the verification, a noted one does not", "[verify]") {
  const TemporaryFolder folder;
  BenchOptions options;
  options.out = folder.path().string();
  options.context = "osmesa";
  options.quiet = true;
  Bench bench(options, "verify");
  Verification verification(bench, false);
  verification.add({"One", "a \"quoted\" case", "m", 2, 0, 1, "at most 1", false});
  CHECK(verification.failed() == 0);
  verification.add({"Two", "other", "", 2, 0, 1, "at most 1"});
  CHECK(verification.failed() == 1);
  verification.write();
  const std::string table = read_file(folder / "verify.csv");
  CAPTURE(table);
  CHECK(table.find("\"One\",\"a \"\"quoted\"\" case\",2,m,,,noted,\"at most 1\"") != std::string::npos);
  CHECK(table.find("\"Two\",\"other\",2,,0,1,failed,\"at most 1\"") != std::string::npos);
  CHECK(read_file(folder / "report.html").find("0 of 1 passed") != std::string::npos);
}

TEST_CASE("bodies of the tests have the elements, supports and motions that they say", "[verify]") {
  const Model beam = hanging_beam(4, 0.3, ElementOrder::quadratic);
  CHECK(beam.tets.size() == 24);
  CHECK(count_of(beam) == "24 quadratic tets");
  CHECK(beam.fixed.size() == 9);
  Model box = solid(make_box(2, 2, 2, {1, 1, 1}), Material(), ElementOrder::linear, {});
  prescribe_surface(box, {1, 1, 1}, [](const Eigen::Vector3d& x) -> Eigen::Vector3d { return 0.1 * x; });
  CHECK(box.motions.front().vertices.size() == 26);
  const State state = equilibrium(box);
  CHECK((displacement_at(box, state, {0.5, 0.5, 0.5}) - Eigen::Vector3d(0.05, 0.05, 0.05)).norm() < 1e-8);
}
