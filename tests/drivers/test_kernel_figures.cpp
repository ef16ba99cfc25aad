// Registers and spills of every kernel on graphics chips that need not be there: Mesa's Vulkan driver for AMD compiles
// for them. A kernel that spills or that holds many more registers than before is slow there, and nothing else shows
// it. scripts/update_kernel_figures.sh renews the table.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "base/file.h"
#include "tests/drivers/kernel_table.h"
#include "tests/support/gpu/gpu_fixture.h"

namespace fascia::test {
namespace {

namespace fs = std::filesystem;

const fs::path kTable = source_dir() / "tests/drivers/kernel_figures.csv";
const fs::path kPage = source_dir() / "docs/concepts/gpu.md";
constexpr int kLeastRegisters = 64;  // of the page's table

/// The description of Mesa's Vulkan driver for AMD; empty without one.
std::string driver_file() {
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator("/usr/share/vulkan/icd.d", none))
    if (entry.path().filename().string().starts_with("radeon_icd")) return entry.path().string();
  return "";
}

/// As SPIR-V beside the texts: uniforms of OpenGL become a block, and blocks get numbers.
void translate(const fs::path& folder, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    const std::string file = (folder / std::to_string(k)).string();
    const CommandResult result =
        run_command({FASCIA_GLSLANG, "-V", "-R", "--auto-map-bindings", "--auto-map-locations", "--target-env",
                     "vulkan1.1", "-S", "comp", "-o", file + ".spv", file + ".comp"});
    if (result.exit_code != 0) FAIL(read_file(file + ".comp").substr(0, 2000) << result.out << result.err);
  }
}

StoredTable compile(const std::map<KernelName, std::string>& texts) {
  const TemporaryFolder folder;
  std::size_t count = 0;
  for (const auto& [kernel, text] : texts) write_file(folder / (std::to_string(count++) + ".comp"), text);
  translate(folder.path(), count);
  StoredTable table;
  for (std::size_t c = 0; c < kChips.size(); ++c) {
    std::vector<std::string> command{"env", "VK_ICD_FILENAMES=" + driver_file(), "MESA_SHADER_CACHE_DISABLE=true",
                                     std::string("RADV_FORCE_FAMILY=") + kChips[c], FASCIA_KERNEL_FIGURES};
    for (std::size_t k = 0; k < count; ++k) command.push_back(std::to_string(k) + ".spv");
    const CommandResult result = run_command(command, folder.path());
    INFO(kChips[c] << ": " << result.err);
    REQUIRE(result.exit_code == 0);
    std::istringstream lines(result.out);
    std::getline(lines, table.driver);
    for (const auto& [kernel, text] : texts) {
      std::string line;
      REQUIRE(std::getline(lines, line));
      ChipFigures& chip = table.kernels[kernel][c];
      REQUIRE(std::sscanf(line.c_str(), "%*[^,],%d,%d,%d,%d", &chip.registers, &chip.waves, &chip.lds_bytes,
                          &chip.spills) == 4);
    }
  }
  return table;
}

StoredTable compile_all() {
  const Gpu gpu(gl::LoadPath::storage);
  return compile(kernel_texts());
}

bool no_driver() {
  if (!driver_file().empty()) return false;
  WARN("Mesa's Vulkan driver for AMD is not installed");
  return true;
}

}  // namespace

TEST_CASE("no kernel spills, or needs many more registers than in the table") {
  if (no_driver()) return;
  StoredTable table = read_table(kTable);
  const StoredTable now = compile_all();
  CHECK(now.kernels.size() > 100);
  if (now.driver != table.driver) {
    WARN("the table is of " << table.driver << ", not of " << now.driver << ": only spills are compared");
    table.kernels = now.kernels;
  }
  for (const std::string& line : complaints(table.kernels, now.kernels)) FAIL_CHECK(line);
}

TEST_CASE("the page about GPUs has the figures of the table") {
  const std::string page = read_file(kPage);
  for (const std::string& row : summary(read_table(kTable).kernels, kLeastRegisters)) CHECK(contains(page, row));
}

TEST_CASE("a table is read as it was written") {
  const TemporaryFolder folder;
  const StoredTable table = read_table(kTable);
  write_table(folder / "copy.csv", table);
  CHECK(read_file(folder / "copy.csv") == read_file(kTable));
}

TEST_CASE("complaints name the kernel, the chip and the change") {
  const KernelName force{"sim/force.comp", "damping"};
  const KernelTable table{{force, {{{64, 16, 0, 0}, {60, 4, 0, 0}}}}};
  KernelTable now = table;
  CHECK(complaints(table, now).empty());
  now[force][1].registers += kMoreRegisters;
  CHECK(complaints(table, now).empty());
  ++now[force][1].registers;
  CHECK(complaints(table, now) ==
        std::vector<std::string>{"sim/force.comp [damping] on VEGA10: 69 registers instead of 60"});
  now = table;
  now[force][0].spills = 3;
  CHECK(complaints(table, now) == std::vector<std::string>{"sim/force.comp [damping] on NAVI21: spills 3"});
  now = table;
  now[{"sim/new.comp", ""}] = {};
  CHECK(complaints(table, now) == std::vector<std::string>{"sim/new.comp: not in the table"});
  CHECK(complaints(now, table) == std::vector<std::string>{"sim/new.comp: in the table, but no solver links it"});
}

// A kernel that holds more numbers than the chips have registers, and the same one with less.
TEST_CASE("the compiler states the registers and the spills of a kernel") {
  if (no_driver()) return;
  const auto figures_of = [](int numbers) {
    std::string text =
        "#version 430 core\nlayout(local_size_x = 64) in;\n"
        "layout(std430) buffer Held { float held[]; };\nvoid main() {\n  uint i = gl_GlobalInvocationID.x;\n";
    const auto at = [](int k) { return "held[i + " + std::to_string(64 * k) + "u]"; };
    for (int k = 0; k < numbers; ++k) text += "  float x" + std::to_string(k) + " = " + at(k) + ";\n";
    text += "  memoryBarrierBuffer();\n  barrier();\n";
    for (int k = 0; k < numbers; ++k)
      text +=
          "  " + at(k) + " = x" + std::to_string(numbers - 1 - k) + " + x" + std::to_string((k * 7) % numbers) + ";\n";
    return compile({{{"held", ""}, text + "}\n"}}).kernels.begin()->second;
  };
  for (const ChipFigures& chip : figures_of(50)) {
    CHECK(chip.spills == 0);
    CHECK((chip.registers >= 50 && chip.registers <= 96));
  }
  for (const ChipFigures& chip : figures_of(400)) CHECK(chip.spills > 0);
}

// Not run by ctest: scripts/update_kernel_figures.sh.
TEST_CASE("renews the table and prints the rows of the page", "[.renew]") {
  const StoredTable table = compile_all();
  write_table(kTable, table);
  for (const std::string& row : summary(table.kernels, kLeastRegisters)) std::puts(row.c_str());
}

}  // namespace fascia::test
