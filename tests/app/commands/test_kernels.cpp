// fascia kernels fills a driver's cache.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "tests/support/support.h"

using namespace fascia::test;

TEST_CASE("the kernels of a scene are compiled into the driver's cache, and no state is lost or written") {
  const TemporaryFolder folder;
  setenv("MESA_SHADER_CACHE_DIR", folder.path().c_str(), 1);
  const std::string scene = (source_dir() / "assets/scenes/cube.json").string();
  const CommandResult result = run_fascia({"kernels", scene, "--context", "egl", "--quiet"}, folder.path());
  unsetenv("MESA_SHADER_CACHE_DIR");
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK(result.out.empty());
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
    files += entry.is_regular_file();
  CHECK(files > 1);  // the index, and kernels
}

TEST_CASE("kernels of a scene that does not exist") {
  const CommandResult result = run_fascia({"kernels", "missing.json"});
  CHECK(result.exit_code == 1);
  CHECK_THAT(result.err, Catch::Contains("missing.json"));
}
