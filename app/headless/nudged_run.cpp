#include "app/headless/nudged_run.h"

#include "base/error.h"
#include "base/interrupt.h"

namespace fascia {

Sensitivity measure_sensitivity(const RenderOptions& options, const Outcome& outcome) {
  RenderOptions quiet = options;  // the run said everything
  quiet.quiet = true;
  Headless headless(quiet, kNudge);
  headless.run();
  if (interrupted())
    throw Error(options.input, "was interrupted", "expected time for a second run, which measures the sensitivity");
  return sensitivity_of(outcome, headless.outcome());
}

std::vector<std::string> renew_goldens(const RenderOptions& options, const Outcome& outcome) {
  const GoldenFiles goldens = options.goldens();
  std::vector<std::string> changes = update_goldens(outcome, goldens);
  for (std::string& change : update_sensitivity(measure_sensitivity(options, outcome), goldens))
    changes.push_back(std::move(change));
  return changes;
}

}  // namespace fascia
