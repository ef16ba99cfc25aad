// fascia info --device: the report of a device that computes, and of one whose kernels do something else.
// Covers: sim/gpu/self_test/self_test, sim/gpu/self_test/trial_box
// Covers: sim/gpu/self_test/kernel_rows, sim/gpu/self_test/step_rows
#include <catch2/catch.hpp>

#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

/// The shaders, with one line of a file replaced.
struct OtherShaders {
  OtherShaders(const fs::path& file, const std::string& line, const std::string& other) {
    fs::copy(source_dir() / "shaders", folder / "shaders", fs::copy_options::recursive);
    fs::create_directories(folder / "assets");
    std::string text = read_file(folder / "shaders" / file);
    const std::size_t at = text.find(line);
    REQUIRE(at != std::string::npos);
    write_file(folder / "shaders" / file, text.replace(at, line.size(), other));
  }
  TemporaryFolder folder;
};

CommandResult tested(const std::string& data_dir) {
  return run_fascia({"info", "--device", "--context", "osmesa", "--loads", "texel", "--data-dir", data_dir});
}

}  // namespace

TEST_CASE("the report of a device that computes", "[info_device]") {
  const CommandResult result = tested(source_dir().string());
  INFO(result.out << result.err);
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
  for (const char* part : {"renderer", "storage blocks a kernel", "read by texel", "EGL", "surfaceless", "predict",
                           "elastic_force, gradient (squared)", "two_level + subspace", "contact_*",
                           "all kernels compute what they should"})
    CHECK(result.out.find(part) != std::string::npos);
  CHECK(result.out.find("WRONG") == std::string::npos);
}

TEST_CASE("a kernel that computes something else is named, and so is the first of those that depend on it",
          "[info_device]") {
  struct Wrong {
    const char *file, *line, *other, *kernels;
  };
  const Wrong wrong = GENERATE(Wrong{"sim/step/predict.comp", "vec3 all = u + (inertial + fall);",
                                     "vec3 all = u + (inertial - fall);", "predict"},
                               Wrong{"sim/two_level/coarse_restrict.comp", "coarse_gradient[3u * j] = back.x;",
                                     "coarse_gradient[3u * j] = -back.x;", "block_inverse, coarse_*"});
  const OtherShaders shaders(wrong.file, wrong.line, wrong.other);
  const CommandResult result = tested(shaders.folder.path().string());
  INFO(result.out << result.err);
  CHECK(result.exit_code == 1);
  CHECK(result.err.find(std::string(": ") + wrong.kernels) != std::string::npos);
  CHECK(result.err.find("is off by ") != std::string::npos);
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
}

TEST_CASE("a device that EGL does not have, and one that its context does not have", "[info_device]") {
  for (const auto& [arguments, part] :
       {std::pair(std::vector<std::string>{"info", "--device", "99"}, "--device 99: EGL has no device of this number"),
        std::pair(std::vector<std::string>{"info", "--device", "0", "--context", "osmesa"}, "OSMesa has no devices")}) {
    const CommandResult result = run_fascia(arguments);
    INFO(result.err);
    CHECK(result.exit_code == 1);
    CHECK(result.err.find(part) != std::string::npos);
  }
  CHECK(run_fascia({"info", "--device", "one"}).exit_code == 2);
}
