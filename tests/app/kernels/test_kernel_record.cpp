// What a window remembers of the kernels in its driver's cache.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "app/kernels/kernel_record.h"
#include "app/system/paths.h"
#include "base/file.h"
#include "sim/grab/build_model.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

// A driver's cache of its own, at the place that Mesa takes from this variable.
struct DriverCache {
  TemporaryFolder folder;
  std::string before = std::getenv("MESA_SHADER_CACHE_DIR") ? std::getenv("MESA_SHADER_CACHE_DIR") : "";
  DriverCache() {
    setenv("MESA_SHADER_CACHE_DIR", folder.path().c_str(), 1);
    fs::create_directories(folder / "mesa_shader_cache");
  }
  ~DriverCache() {
    if (before.empty())
      unsetenv("MESA_SHADER_CACHE_DIR");
    else
      setenv("MESA_SHADER_CACHE_DIR", before.c_str(), 1);
  }
};

Scene shipped(const char* name) { return open_scene(find_data_dir("") / "assets/scenes" / name); }

}  // namespace

TEST_CASE("the kernels of a scene are known until the scene, the driver or its cache changes") {
  const DriverCache cache;
  const TemporaryFolder folder;
  const fs::path file = folder / "state/kernels";
  const KernelRecord record(file, "llvmpipe");
  Scene cube = shipped("cube.json");
  CHECK_FALSE(record.has(cube));
  record.add(cube);
  CHECK(record.has(cube));
  CHECK(KernelRecord(file, "llvmpipe").has(cube));
  CHECK_FALSE(KernelRecord(file, "another").has(cube));
  CHECK_FALSE(record.has(shipped("beam.json")));
  INFO("painting needs new kernels with its first region only, and the camera none");
  Scene painted = cube;
  painted.camera.emplace();
  CHECK(record.same(cube, painted));
  painted.bodies[0].regions = {{"tumour", {{3, 5}}}};
  CHECK_FALSE(record.same(cube, painted));
  CHECK_FALSE(record.has(painted));
  Scene more = painted;
  more.bodies[0].regions = {{"tumour", {{3, 5}, {8, 9}}}};
  CHECK(record.same(painted, more));
  cube.solver.method = Method::jacobi;
  CHECK_FALSE(record.has(cube));
  record.add(cube);
  record.add(cube);
  const std::string lines = read_file(file);
  CHECK(std::count(lines.begin(), lines.end(), '\n') == 2);
  fs::rename(cache.folder / "mesa_shader_cache", cache.folder / "kept");  // so that its number is not used again
  CHECK_FALSE(record.has(cube));
  fs::create_directories(cache.folder / "mesa_shader_cache");
  CHECK_FALSE(record.has(cube));
}

TEST_CASE("without a file, or with one that cannot be written, nothing is remembered and nothing fails") {
  const DriverCache cache;
  const TemporaryFolder folder;
  const Scene cube = shipped("cube.json");
  const KernelRecord none("", "llvmpipe");
  none.add(cube);
  CHECK_FALSE(none.has(cube));
  write_file(folder / "file", "");
  const KernelRecord blocked(folder / "file/kernels", "llvmpipe");
  blocked.add(cube);
  CHECK_FALSE(blocked.has(cube));
}

TEST_CASE("the record keeps the latest scenes") {
  const DriverCache cache;
  const TemporaryFolder folder;
  const KernelRecord record(folder / "kernels", "llvmpipe");
  Scene scene = shipped("cube.json");
  for (int i = 0; i < 250; ++i) {
    scene.solver.iterations = 1 + i;
    record.add(scene);
  }
  CHECK(record.has(scene));
  scene.solver.iterations = 100;
  CHECK(record.has(scene));
  scene.solver.iterations = 10;
  CHECK_FALSE(record.has(scene));
}
