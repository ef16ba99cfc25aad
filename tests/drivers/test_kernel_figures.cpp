// Registers, spills and width of every kernel on graphics chips that need not be there: Mesa's drivers for AMD and
// Intel compile for them. A kernel that spills, that holds many more registers or is less wide than before is slow
// there, and nothing else shows it. scripts/update_kernel_figures.sh renews the table.
#include <catch2/catch.hpp>

#include "base/file.h"
#include "tests/drivers/compilers.h"
#include "tests/support/gpu/gpu_fixture.h"

namespace fascia::test {
namespace {

const std::filesystem::path kTable = source_dir() / "tests/drivers/kernel_figures.csv";
const std::filesystem::path kPage = source_dir() / "docs/concepts/gpu.md";
constexpr int kLeastRegisters = 64;  // of the page's table

StoredTable compile_all() {
  const Gpu gpu(gl::LoadPath::storage);
  return compile(kernel_texts());
}

}  // namespace

TEST_CASE("no kernel spills more, needs many more registers or is less wide than in the table") {
  StoredTable table = read_table(kTable);
  const StoredTable now = compile_all();
  if (now.driver.empty()) return;
  CHECK(now.kernels.size() > 100);
  if (now.driver != table.driver) {
    WARN("the table is of " << table.driver << ", not of " << now.driver << ": only spills on AMD's chips count");
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
  const KernelTable table{{force, {{{{64, 16, 0, 0}, {60, 4, 0, 0}}}, {16, 500, 0, 0}}}};
  KernelTable now = table;
  CHECK(complaints(table, now).empty());
  now[force].chips[1].registers += kMoreRegisters;
  CHECK(complaints(table, now).empty());
  ++now[force].chips[1].registers;
  CHECK(complaints(table, now) ==
        std::vector<std::string>{"sim/force.comp [damping] on VEGA10: 69 registers instead of 60"});
  now = table;
  now[force].chips[0].spills = 3;
  CHECK(complaints(table, now) == std::vector<std::string>{"sim/force.comp [damping] on NAVI21: spills 3"});
  now = table;
  now[force].intel = {8, 450, 3, 5};
  CHECK(complaints(table, now) ==
        std::vector<std::string>{
            "sim/force.comp [damping] on TGL: SIMD8 instead of SIMD16",
            "sim/force.comp [damping] on TGL: 3 spills and 5 fills instead of 0 spills and 0 fills"});
  now[force].intel = {};  // without that driver
  CHECK(complaints(table, now).empty());
  now = table;
  now[{"sim/new.comp", ""}] = {};
  CHECK(complaints(table, now) == std::vector<std::string>{"sim/new.comp: not in the table"});
  CHECK(complaints(now, table) == std::vector<std::string>{"sim/new.comp: in the table, but no solver links it"});
}

// A kernel that holds more numbers than the chips have registers, and the same one with less.
TEST_CASE("compilers state the registers, the width and the spills of a kernel") {
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
  const bool amd = compiles_for_amd(), intel = compiles_for_intel();
  const KernelFigures few = figures_of(5), some = figures_of(50), many = figures_of(400);
  for (std::size_t c = 0; amd && c < kChips.size(); ++c) {
    CHECK(some.chips[c].spills == 0);
    CHECK((some.chips[c].registers >= 50 && some.chips[c].registers <= 96));
    CHECK(many.chips[c].spills > 0);
  }
  if (!intel) return;
  CHECK(few.intel.width >= 16);
  CHECK(few.intel.spills + few.intel.fills + some.intel.spills + some.intel.fills == 0);
  CHECK(many.intel.width == 8);
  CHECK(many.intel.spills > 0);
  CHECK(many.intel.fills > 0);
}

// Not run by ctest: scripts/update_kernel_figures.sh.
TEST_CASE("renews the table and prints the rows of the page", "[.renew]") {
  REQUIRE((compiles_for_amd() && compiles_for_intel()));
  const StoredTable table = compile_all();
  write_table(kTable, table);
  for (const std::string& row : summary(table.kernels, kLeastRegisters)) std::puts(row.c_str());
}

}  // namespace fascia::test
