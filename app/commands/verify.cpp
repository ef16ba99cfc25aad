// fascia verify: the tests that a reviewer asks of a finite-element solver, with a report.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

#include "app/cli/command_line.h"
#include "app/commands/command.h"
#include "app/verify/verification.h"
#include "base/suggest.h"

namespace fascia {
namespace {

struct VerifyOptions : BenchOptions {
  bool full = false;
  std::vector<std::string> only;  // names of tests
};

struct Test {
  const char* name;
  void (*verify)(Verification&);
};
constexpr Test kTests[] = {{"patches", verify_patches},
                           {"cantilever", verify_cantilever},
                           {"cook", verify_cook},
                           {"twist", verify_twist},
                           {"block", verify_block},
                           {"frequencies", verify_frequencies},
                           {"orders_space", verify_orders_in_space},
                           {"orders_time", verify_orders_in_time},
                           {"estimates", verify_estimates},
                           {"estimates_time", verify_estimates_in_time},
                           {"estimates_motion", verify_estimates_in_motion},
                           {"stresses", verify_stresses},
                           {"gpu", verify_gpu}};

int run_verify(const VerifyOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  try {
    Bench bench(options, "verify");
    bench.say(describe(bench.graphics));
    if (!bench.has_gnuplot) bench.say("no gnuplot: the report has no charts");
    Verification verification(bench, options.full);
    for (const Test& test : kTests) {
      if (!options.only.empty() && std::find(options.only.begin(), options.only.end(), test.name) == options.only.end())
        continue;
      bench.stop_if_interrupted();
      test.verify(verification);
    }
    verification.write();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    bench.say((bench.folder / "report.html").string() + ", after " + std::to_string(std::lround(elapsed.count())) +
              " s");
    if (verification.failed() == 0) return exit_done;
    std::cerr << "fascia: " << verification.failed() << " of " << verification.findings().size()
              << " findings outside their bounds\n";
    return exit_failed;
  } catch (const Interrupted&) {
    return exit_interrupted;
  }
}

}  // namespace

void add_verify(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<VerifyOptions>();
  CLI::App& command = *program.add_subcommand(
      "verify", "patch tests, standard problems, orders of convergence: a report with the source of every truth");
  command.add_option("--out", options->out, "folder for report.html, verify.csv and charts, made if missing")
      ->type_name("DIR")
      ->required();
  command.add_flag("--full", options->full, "finer meshes, too");
  std::vector<std::string> names;
  for (const Test& test : kTests) names.push_back(test.name);
  command.add_option("--only", options->only, "only these tests: " + join(names))
      ->type_name("TEST,...")
      ->delimiter(',')
      ->check(CLI::IsMember(names));
  add_graphics(command, *options);
  add_examples(command, {"fascia verify --out verification", "fascia verify --only patches,cook --out verification"},
               "a finding is outside its bounds");
  command.callback([&invocation, options] { invocation.run = [options] { return run_verify(*options); }; });
}

}  // namespace fascia
