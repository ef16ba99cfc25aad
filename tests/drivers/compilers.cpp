#include "tests/drivers/compilers.h"

#include <catch2/catch.hpp>
#include <cstdio>
#include <sstream>

#include "base/file.h"

namespace fascia::test {
namespace {

namespace fs = std::filesystem;

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

/// Files 0.comp, 1.comp, as their names go on the command line of the programs that compile them.
std::vector<std::string> with_files(std::vector<std::string> command, std::size_t count, const char* ending) {
  for (std::size_t k = 0; k < count; ++k) command.push_back(std::to_string(k) + ending);
  return command;
}

/// The driver, and one line for each kernel in the order of the table.
template <class Take>
void take_figures(const CommandResult& result, StoredTable& table, Take take) {
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  std::istringstream lines(result.out);
  std::string driver, line;
  std::getline(lines, driver);
  CHECK((table.driver.empty() || table.driver == driver));
  table.driver = driver;
  for (auto& [kernel, figures] : table.kernels) {
    REQUIRE(std::getline(lines, line));
    REQUIRE(take(line.c_str(), figures) == 4);
  }
}

void compile_for_amd(const fs::path& folder, StoredTable& table) {
  translate(folder, table.kernels.size());
  for (std::size_t c = 0; c < kChips.size(); ++c)
    take_figures(run_command(with_files({"env", "VK_ICD_FILENAMES=" + driver_file(), "MESA_SHADER_CACHE_DISABLE=true",
                                         std::string("RADV_FORCE_FAMILY=") + kChips[c], FASCIA_KERNEL_FIGURES},
                                        table.kernels.size(), ".spv"),
                             folder),
                 table, [&](const char* line, KernelFigures& figures) {
                   ChipFigures& chip = figures.chips[c];
                   return std::sscanf(line, "%*[^,],%d,%d,%d,%d", &chip.registers, &chip.waves, &chip.lds_bytes,
                                      &chip.spills);
                 });
}

void compile_for_intel(const fs::path& folder, StoredTable& table) {
  take_figures(run_on_intel("tgl", with_files({FASCIA_INTEL_FIGURES}, table.kernels.size(), ".comp"), "", folder),
               table, [](const char* line, KernelFigures& figures) {
                 IntelFigures& intel = figures.intel;
                 return std::sscanf(line, "%*[^,],%d,%d,%d,%d", &intel.width, &intel.instructions, &intel.spills,
                                    &intel.fills);
               });
}

bool is_there(bool driver, const char* what) {
  if (!driver) WARN(what << " is not installed: left out");
  return driver;
}

}  // namespace

bool compiles_for_amd() {
  return is_there(!driver_file().empty() && *FASCIA_GLSLANG && *FASCIA_KERNEL_FIGURES,
                  "Mesa's Vulkan driver for AMD, libvulkan-dev or glslang-tools");
}

bool compiles_for_intel() {
  return is_there(*FASCIA_IDLE_I915 && run_on_intel("tgl", {FASCIA_INTEL_FIGURES}).exit_code == 0,
                  "libdrm-dev, or Mesa's OpenGL driver for Intel in a version that starts on idle_i915,");
}

CommandResult run_on_intel(const std::string& chip, const std::vector<std::string>& command, const std::string& fault,
                           const fs::path& folder) {
  std::vector<std::string> all{"env",
                               "-u",
                               "LIBGL_ALWAYS_SOFTWARE",
                               "MESA_SHADER_CACHE_DISABLE=true",
                               "FASCIA_CHIP=" + chip,
                               "FASCIA_FAULT=" + fault,
                               "LD_PRELOAD=" FASCIA_IDLE_I915 + std::string(fault.empty() ? "" : ":" FASCIA_GL_FAULTS)};
  all.insert(all.end(), command.begin(), command.end());
  return run_command(all, folder);
}

StoredTable compile(const std::map<KernelName, std::string>& texts) {
  const TemporaryFolder folder;
  StoredTable table;
  std::size_t count = 0;
  for (const auto& [kernel, text] : texts) {
    write_file(folder / (std::to_string(count++) + ".comp"), text);
    table.kernels[kernel];
  }
  if (compiles_for_amd()) compile_for_amd(folder.path(), table);
  if (compiles_for_intel()) compile_for_intel(folder.path(), table);
  return table;
}

}  // namespace fascia::test
