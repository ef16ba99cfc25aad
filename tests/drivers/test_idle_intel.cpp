// The program on Mesa's OpenGL driver for Intel (iris) over a kernel that executes nothing: limits, kernels, uploads
// and commands are a graphics card's, and no result is. Whatever the program does with what it reads, it ends with one
// line.
#include <catch2/catch.hpp>

#include "tests/drivers/compilers.h"

namespace fascia::test {
namespace {

const std::string kFirstRead = "trusted:1";  // the probe that a solver begins with finds a device that computes

CommandResult run_idle(const std::string& chip, std::vector<std::string> arguments, const std::string& fault = "") {
  arguments.insert(arguments.begin(), FASCIA_BINARY);
  arguments.insert(arguments.end(), {"--context", "egl"});
  return run_on_intel(chip, arguments, fault);
}

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(source_dir() / "assets/scenes"))
    if (entry.path().extension() == ".json") scenes.push_back(entry.path().string());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

}  // namespace

// Later versions may ask the kernel for more, and the tests below are left out then.
TEST_CASE("Mesa's driver for Intel of the version of the table starts") {
  const StoredTable table = read_table(source_dir() / "tests/drivers/kernel_figures.csv");
  if (!*FASCIA_IDLE_I915 || !std::filesystem::exists("/usr/lib/x86_64-linux-gnu/dri/iris_dri.so")) return;
  const CommandResult result = run_on_intel("tgl", {FASCIA_INTEL_FIGURES});
  INFO(result.err);
  if (contains(result.out, table.driver)) CHECK(result.exit_code == 0);
}

TEST_CASE("a chip that executes nothing is named, with its limits") {
  if (!compiles_for_intel()) return;
  const auto [chip, renderer] = GENERATE(std::pair("skl", "Mesa Intel(R) HD Graphics 530 (SKL GT2)"),
                                         std::pair("tgl", "Mesa Intel(R) Xe Graphics (TGL GT2)"),
                                         std::pair("dg2", "Mesa Intel(R) Arc(tm) A770 Graphics (DG2)"));
  const CommandResult result = run_idle(chip, {"info", "--device"});
  INFO(result.out << result.err);
  CHECK(result.exit_code == 1);
  CHECK(lines_of(result.err) == 1);
  for (const std::string& part :
       {std::string("renderer     ") + renderer, std::string("read by ssbo"), std::string("16 storage blocks a kernel"),
        std::string("device 0     ") + renderer, std::string("fill: a kernel that ran left nothing in its buffer"),
        std::string("heat_tet, publish: as before")})
    CHECK(contains(result.out, part));
  CHECK(contains(result.err,
                 std::string("fascia: ") + renderer + ": fill: a kernel that ran left nothing in its buffer"));
}

TEST_CASE("the self-test links every kernel on Intel, and names each that computes nothing") {
  if (!compiles_for_intel()) return;
  const CommandResult result = run_idle("tgl", {"info", "--device", "--loads", "ssbo"}, kFirstRead);
  INFO(result.out << result.err);
  CHECK(result.exit_code == 1);
  CHECK(contains(result.err, "predict is off by 1, expected at most 1e-06, read by ssbo; and 36 more"));
  CHECK(lines_of(result.err) == 1);
  std::istringstream report(result.out.substr(result.out.find("self-test")));
  std::string line;
  std::getline(report, line);
  std::size_t rows = 0;
  while (std::getline(report, line)) {
    INFO(line);
    CHECK(line.starts_with("  WRONG ") == !line.ends_with("  fill"));
    CHECK_FALSE(contains(line, ": "));  // a row without a number failed otherwise: a kernel that does not link
    ++rows;
  }
  CHECK(rows == 38);
}

TEST_CASE("every shipped scene ends with one line on a device that computes nothing") {
  if (!compiles_for_intel()) return;
  const std::string scene = GENERATE(from_range(shipped_scenes()));
  const CommandResult result = run_idle("tgl", {"run", scene, "--steps", "3", "--quiet"}, kFirstRead);
  INFO(scene << ": " << result.exit_code << ", " << result.out << result.err);
  CHECK(result.exit_code == 1);
  CHECK(lines_of(result.err) == 1);
  CHECK(contains(result.err, "expected a device that computes"));
}

TEST_CASE("a picture of the reference solver's state is drawn on Intel") {
  if (!compiles_for_intel()) return;
  const auto [scene, chip] = GENERATE(std::pair("liver", "tgl"), std::pair("cube", "dg2"));
  const TemporaryFolder folder;
  const std::string picture = folder / "picture.png";
  const CommandResult result =
      run_idle(chip,
               {"render", (source_dir() / "assets/scenes" / (std::string(scene) + ".json")).string(), "--reference",
                "--steps", "1", "--quality", "full", "--ui", "--wireframe", "--out", picture},
               kFirstRead);
  INFO(result.out << result.err);
  CHECK(result.exit_code == 0);
  CHECK(std::filesystem::exists(picture));
}

}  // namespace fascia::test
