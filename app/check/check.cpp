#include "app/check/check.h"

#include <chrono>
#include <nlohmann/json.hpp>

#include "app/golden/golden.h"
#include "app/headless/headless.h"
#include "app/system/child_process.h"
#include "base/error.h"
#include "base/interrupt.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path left_behind(const CheckOptions& options, const CheckCase& check, const char* ending) {
  return fs::path(options.out) / (check.name + ending);
}

void keep_failure(const CheckOptions& options, const CheckCase& check, const Outcome& outcome,
                  const Comparison& comparison) {
  if (!check.options.compare.empty())
    write_png(left_behind(options, check, ".new.png"), outcome.picture, outcome.provenance);
  if (!check.options.state.empty()) write_state(left_behind(options, check, ".new.csv"), outcome.mesh, outcome.fields);
  if (comparison.picture) write_png(left_behind(options, check, ".diff.png"), *comparison.picture, outcome.provenance);
}

// Also handles folders with names that are not UTF-8.
std::string text_of(const json& found) { return found.dump(-1, ' ', false, json::error_handler_t::replace); }

// Runs in the child process. Returns its findings as a text.
std::string judge(const CheckCase& check, const CheckOptions& options) {
  Headless headless(check.options);
  headless.run();
  if (interrupted())
    throw Error(check.name, "was interrupted", "expected time for all of its steps");  // so that no results are written
  const Outcome outcome = headless.outcome();
  if (options.update) return text_of(json{{"lines", update_goldens(outcome, check.options.goldens())}});
  const Comparison comparison = compare(outcome, check.options.goldens(), check.options.limits);
  json found{{"passed", comparison.passed()}, {"lines", json::array()}};
  for (const Finding& finding : comparison.findings)
    if (!finding.passed) found["lines"].push_back(finding.text);
  for (const std::string& reason : comparison.reasons) found["lines"].push_back(reason);
  if (comparison.mean) found["mean"] = *comparison.mean;
  if (comparison.share) found["share"] = *comparison.share;
  if (comparison.deviation) found["deviation"] = *comparison.deviation;
  if (!comparison.passed() && !options.out.empty()) keep_failure(options, check, outcome, comparison);
  return text_of(found);
}

CheckResult result_of(const ChildReport& report, bool update) {
  using Verdict = CheckResult::Verdict;
  CheckResult result;
  result.said = report.said;
  if (!report.failure.empty()) {
    result.lines = {report.failure};
    return result;
  }
  const json found = json::parse(report.answer);
  result.verdict = update ? Verdict::updated : found.at("passed").get<bool>() ? Verdict::passed : Verdict::failed;
  result.lines = found.at("lines").get<std::vector<std::string>>();
  const auto number = [&](const char* key, std::optional<double>& field) {
    if (found.contains(key) && found[key].is_number()) field = found[key].get<double>();
  };
  number("mean", result.mean);
  number("share", result.share);
  number("deviation", result.deviation);
  return result;
}

}  // namespace

CheckResult run_check(const CheckCase& check, const CheckOptions& options) {
  CheckCase made = check;
  made.options.context = options.context;
  made.options.loads = options.loads;
  made.options.data_dir = options.data_dir;
  made.options.command_line = options.command_line;
  if (!options.out.empty())
    for (const char* ending : {".new.png", ".new.csv", ".diff.png"}) {
      std::error_code ignored;
      fs::remove(left_behind(options, check, ending), ignored);
    }
  const auto start = std::chrono::steady_clock::now();
  CheckResult result = result_of(run_in_child([&] { return judge(made, options); }, options.timeout), options.update);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace fascia
