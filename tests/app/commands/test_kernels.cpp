// fascia kernels fills a driver's cache.
#include <algorithm>
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

TEST_CASE("kernels of whole steps are fewer than those with steps of a part") {
  const TemporaryFolder folder;
  setenv("MESA_SHADER_CACHE_DIR", folder.path().c_str(), 1);
  const std::string scene = (source_dir() / "assets/scenes/beam.json").string();
  const auto kept = [&](const std::vector<std::string>& options) {  // in the cache, after another run
    std::vector<std::string> arguments{"kernels", scene, "--context", "egl", "--quiet", "--kernels", "single"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const CommandResult result = run_fascia(arguments, folder.path());
    CHECK(result.exit_code == 0);
    const std::filesystem::recursive_directory_iterator entries(folder.path());
    return std::count_if(begin(entries), end(entries), [](const auto& entry) { return entry.is_regular_file(); });
  };
  const auto whole = kept({"--whole-steps"}), again = kept({"--whole-steps"}), all = kept({});
  unsetenv("MESA_SHADER_CACHE_DIR");
  CHECK(again == whole);
  CHECK(all > whole);
}
