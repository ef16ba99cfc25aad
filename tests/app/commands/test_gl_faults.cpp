// A driver that fails at some call (tests/support/gl_faults): one line and exit code 1, whatever the call. Kernels are
// dispatched one by one, as on GPUs. FASCIA_FAULTS=all tries every call, which takes minutes.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr const char* kSteps = "6";

CommandResult run_with_fault(const std::string& fault, const std::string& count = "/dev/null") {
  return run_command({"env", "LD_PRELOAD=" FASCIA_GL_FAULTS, "FASCIA_FAULT=" + fault, "FASCIA_FAULT_COUNT=" + count,
                      FASCIA_BINARY, "run", (source_dir() / "assets/scenes/cube.json").string(), "--steps", kSteps,
                      "--context", "osmesa", "--kernels", "single", "--quiet"});
}

/// The number of such calls in a run without a fault.
long calls_of(const std::string& kind) {
  const TemporaryFolder folder;
  const CommandResult result = run_with_fault(kind + ":1000000000", (folder / "count").string());
  INFO(kind << ": " << result.err);
  REQUIRE(result.exit_code == 0);
  REQUIRE(result.err.empty());
  return std::stol(read_file(folder / "count"));
}

/// Of so many calls: all, or the first, the last and some between.
std::vector<long> tried(long calls, long some) {
  const char* const asked = std::getenv("FASCIA_FAULTS");
  const long step = asked && std::string(asked) == "all" ? 1 : std::max(1L, (calls - 1) / some);
  std::vector<long> numbers;
  for (long n = 1; n < calls; n += step) numbers.push_back(n);
  numbers.push_back(calls);
  return numbers;
}

void check_fault(const std::string& fault, const std::vector<std::string>& parts) {
  const CommandResult result = run_with_fault(fault);
  INFO(fault << ": exit code " << result.exit_code << ", " << result.err);
  CHECK(result.exit_code == 1);
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  CHECK(std::any_of(parts.begin(), parts.end(),
                    [&](const std::string& part) { return result.err.find(part) != std::string::npos; }));
}

}  // namespace

TEST_CASE("a buffer without room ends with its name", "[faults]") {
  const long calls = calls_of("allocation");
  CAPTURE(calls);
  CHECK(calls > 20);
  for (const long n : tried(calls, 4)) check_fault("allocation:" + std::to_string(n), {"cannot have "});
}

TEST_CASE("a program that does not link ends with its file", "[faults]") {
  const long calls = calls_of("link");
  CAPTURE(calls);
  CHECK(calls > 3);
  for (const long n : tried(calls, 3)) check_fault("link:" + std::to_string(n), {"does not link"});
}

// What the last two would make is shown by nothing here.
TEST_CASE("a driver that discards dispatches, from any one on", "[faults]") {
  check_fault("drop:1", {"a kernel that ran left nothing in its buffer"});
  for (const long n : tried(calls_of("drop") - 2, 6))
    if (n > 1) check_fault("drop:" + std::to_string(n), {"a kernel of a step left nothing in its buffer"});
}

TEST_CASE("a context that is lost at a dispatch is told as such", "[faults]") {
  const long calls = calls_of("lost");
  CAPTURE(calls);
  for (const long n : tried(calls, 4)) check_fault("lost:" + std::to_string(n), {"the device was reset"});
}

// The last two reads are of diagnostics, from which nothing is made here.
TEST_CASE("garbage in reads is no result", "[faults]") {
  for (const long n : tried(calls_of("garbage") - 2, 4))
    check_fault("garbage:" + std::to_string(n), {"expected a device that computes", " is not finite at "});
}
