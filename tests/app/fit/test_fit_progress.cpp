// The record of an interrupted fit.
#include <catch2/catch.hpp>

#include "app/fit/fit_progress.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("the record of a fit is read by the same fit alone", "[fit]") {
  const TemporaryFolder folder;
  write_file(folder / "a.csv", "reaction_y_N\n1\n");
  const Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  const std::vector<Measurement> measured{{folder / "a.csv", 1, {}, {}, {}}};
  const FitProgressFile record(folder.path(), identity_of(scene, measured, "--static"));
  CHECK(!record.read(2));
  record.write({{0.1, -1e-17}, 5, 0.3});
  const auto progress = record.read(2);
  REQUIRE(progress);
  CHECK(progress->inner == std::vector<double>{0.1, -1e-17});
  CHECK(progress->simulations == 5);
  CHECK(progress->start_misfit == 0.3);

  const auto refuses = [&](const Scene& s, const std::string& options, const char* what) {
    CHECK_THROWS_WITH(FitProgressFile(folder.path(), identity_of(s, measured, options)).read(2),
                      Catch::Contains(std::string("progress.json: is of an interrupted fit with ") + what));
  };
  refuses(open_scene(scene.file, {"materials.default.density=1001"}), "--static", "another scene");
  refuses(scene, "", "other options");
  CHECK_THROWS_WITH(record.read(3), Catch::Contains("is no record of a fit"));
  write_file(folder / "a.csv", "reaction_y_N\n2\n");
  refuses(scene, "--static", "another measurement");
  write_file(record.file(), "{}");
  CHECK_THROWS_WITH(record.read(2), Catch::Contains("is no record of a fit"));
  record.remove();
  CHECK(!record.read(2));
}
