// Compilers for graphics chips that need not be there: Mesa's Vulkan driver for AMD, and its OpenGL driver for Intel on
// a kernel that executes nothing (tests/support/intel/idle_i915.cpp).
#pragma once
#include "tests/drivers/kernel_table.h"
#include "tests/support/support.h"

namespace fascia::test {

/// Whether the driver is installed; if not, a test's warning says so.
bool compiles_for_amd();
bool compiles_for_intel();

/// Runs `command` on an Intel chip that executes nothing: "skl", "tgl" or "dg2". `fault`: as FASCIA_FAULT
/// (tests/support/gl_faults), or none.
CommandResult run_on_intel(const std::string& chip, const std::vector<std::string>& command,
                           const std::string& fault = "", const std::filesystem::path& folder = ".");

/// By the drivers that there are. Fails the test if one of them does not compile a text.
StoredTable compile(const std::map<KernelName, std::string>& texts);

}  // namespace fascia::test
