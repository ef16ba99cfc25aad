#include "app/check/check.h"

#include <array>
#include <nlohmann/json.hpp>

#include "app/golden/golden.h"
#include "app/headless/nudged_run.h"
#include "base/error.h"
#include "base/interrupt.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

void keep_failure(const CheckOptions& options, const CheckCase& check, const Outcome& outcome,
                  const Comparison& comparison) {
  if (!check.options.compare.empty()) write_png(new_picture(options.out, check), outcome.picture, outcome.provenance);
  if (!check.options.state.empty()) write_state(new_state(options.out, check), outcome.mesh, outcome.fields);
  if (!check.options.state.empty() && !outcome.contact.empty())
    write_contact_golden(contact_beside(new_state(options.out, check)), outcome.contact);
  if (comparison.picture) write_png(difference(options.out, check), *comparison.picture, outcome.provenance);
}

// Also handles folders with names that are not UTF-8.
std::string text_of(const json& found) { return found.dump(-1, ' ', false, json::error_handler_t::replace); }

// Runs in the child process. Returns its findings as a text.
std::string judge(const CheckCase& check, const CheckOptions& options) {
  if (const std::vector<std::string> missing = missing_goldens(check.options.goldens());
      !options.update && options.out.empty() && !missing.empty())
    return text_of(json{{"passed", false}, {"lines", missing}});  // with a folder the new picture and state are of use
  std::optional<Headless> headless(std::in_place, check.options);
  headless->run();
  if (interrupted())
    throw Error(check.name, "was interrupted", "expected time for all of its steps");  // no results are written
  const Outcome outcome = headless->outcome();
  headless.reset();
  if (options.update) return text_of(json{{"lines", renew_goldens(check.options, outcome)}});
  const Comparison comparison = compare(outcome, check.options.goldens(), check.options.limits);
  json found{{"passed", comparison.passed()}, {"lines", json::array()}};
  for (const Finding& finding : comparison.findings)
    if (!finding.passed) found["lines"].push_back(finding.text);
  for (const std::string& reason : comparison.reasons) found["lines"].push_back(reason);
  if (comparison.mean) found["mean"] = *comparison.mean;
  if (comparison.share) found["share"] = *comparison.share;
  if (comparison.deviation) found["deviation"] = *comparison.deviation;
  if (comparison.contact) found["contact"] = *comparison.contact;
  found["limits"] = {comparison.limits.mean, comparison.limits.share, comparison.limits.state,
                     comparison.limits.contact};
  if (!comparison.passed() && !options.out.empty()) keep_failure(options, check, outcome, comparison);
  return text_of(found);
}

CheckResult result_of(const ChildReport& report, bool update, const GoldenLimits& limits) {
  using Verdict = CheckResult::Verdict;
  CheckResult result;
  result.said = report.said;
  result.limits = limits;
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
  number("contact", result.contact);
  if (found.contains("limits")) {
    const auto widened = found["limits"].get<std::array<double, 4>>();
    result.limits = {widened[0], widened[1], widened[2], widened[3]};
  }
  return result;
}

}  // namespace

fs::path new_picture(const fs::path& out, const CheckCase& check) { return out / (check.name + ".new.png"); }
fs::path new_state(const fs::path& out, const CheckCase& check) { return out / (check.name + ".new.csv"); }
fs::path difference(const fs::path& out, const CheckCase& check) { return out / (check.name + ".diff.png"); }

CheckRun::CheckRun(const CheckCase& check, const CheckOptions& options)
    : update_(options.update), limits_(check.options.limits) {
  CheckCase made = check;
  made.options.context = options.context;
  made.options.loads = options.loads;
  made.options.kernels = options.kernels;
  made.options.quality = options.quality;
  made.options.data_dir = options.data_dir;
  made.options.command_line = options.command_line;
  if (!options.out.empty())
    for (const fs::path& earlier : {new_picture(options.out, check), new_state(options.out, check),
                                    contact_beside(new_state(options.out, check)), difference(options.out, check)}) {
      std::error_code ignored;
      fs::remove(earlier, ignored);
    }
  child_ = std::make_unique<ChildProcess>([&] { return judge(made, options); }, options.timeout);
}

bool CheckRun::ended(int wait_ms) {
  if (!child_->ended(wait_ms)) return false;
  if (seconds_ == 0) seconds_ = std::chrono::duration<double>(Clock::now() - start_).count();
  return true;
}

CheckResult CheckRun::result() const {
  CheckResult result = result_of(child_->report(), update_, limits_);
  result.seconds = seconds_;
  return result;
}

}  // namespace fascia
