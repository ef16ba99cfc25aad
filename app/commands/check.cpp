// fascia check: compares a folder of scenes with their goldens, as a table and as JUnit XML for CI.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iostream>
#include <memory>
#include <thread>

#include "app/check/check.h"
#include "app/check/html_report.h"
#include "app/check/junit.h"
#include "app/cli/command_line.h"
#include "app/cli/name_pattern.h"
#include "app/cli/output_files.h"
#include "app/commands/command.h"
#include "app/golden/golden.h"
#include "app/golden/tolerance.h"
#include "base/error.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/text.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;
using Verdict = CheckResult::Verdict;

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "passed";
    case Verdict::failed:
      return "FAILED";
    case Verdict::error:
      return "ERROR";
    case Verdict::updated:
      return "updated";
  }
  return "";
}

std::string row(const std::vector<std::string>& cells, std::size_t name_width) {
  char text[128];
  std::snprintf(text, sizeof text, "  %-8s %10s %10s %10s %8s", cells[1].c_str(), cells[2].c_str(), cells[3].c_str(),
                cells[4].c_str(), cells[5].c_str());
  return cells[0] + std::string(name_width - cells[0].size(), ' ') + text;
}

std::string cell(const std::optional<double>& value) { return value ? three_digits(*value) : "-"; }

bool is_good(const CheckResult& result) {
  return result.verdict == Verdict::passed || result.verdict == Verdict::updated;
}

void print(const CheckCase& check, const CheckResult& result, std::size_t name_width, bool quiet) {
  if (quiet && is_good(result)) return;
  char seconds[24];
  std::snprintf(seconds, sizeof seconds, "%.1f", result.seconds);
  std::cout << row({check.name, name_of(result.verdict), cell(result.mean), cell(result.share), cell(result.deviation),
                    seconds},
                   name_width)
            << '\n';
  for (const std::string& line : result.lines) std::cout << "    " << line << '\n';
  std::cout.flush();
}

struct Value {
  const char* name;
  std::optional<double> measured;
  double allowed;
};
std::vector<Value> values_of(const CheckResult& result) {
  const GoldenLimits& limits = result.limits;
  return {{"mean", result.mean, limits.mean},
          {"share", result.share, limits.share},
          {"state", result.deviation, limits.state},
          {"contact", result.contact, limits.contact}};
}

JunitCase junit_case(const CheckCase& check, const CheckResult& result) {
  JunitCase made;
  made.name = check.name;
  made.seconds = result.seconds;
  made.output = result.said;
  made.verdict = result.verdict == Verdict::failed  ? JunitCase::Verdict::failed
                 : result.verdict == Verdict::error ? JunitCase::Verdict::error
                                                    : JunitCase::Verdict::passed;
  if (!result.lines.empty()) made.message = result.lines.front();
  for (const std::string& line : result.lines) made.details += line + '\n';
  for (const Value& v : values_of(result)) {
    if (!v.measured) continue;
    made.properties.emplace_back(std::string(v.name) + "_measured", *v.measured);
    made.properties.emplace_back(std::string(v.name) + "_allowed", v.allowed);
  }
  return made;
}

ReportCase report_case(const CheckCase& check, const CheckResult& result, const std::string& out) {
  ReportCase made{check.name, name_of(result.verdict), is_good(result), result.seconds, {}, result.lines,
                  "golden",   check.options.compare};
  for (const Value& v : values_of(result))
    if (v.measured) made.values.push_back({v.name, *v.measured, v.allowed});
  if (made.good || out.empty()) return made;
  std::error_code none;
  const bool compared = fs::exists(difference(out, check), none);
  made.picture = compared ? difference(out, check) : new_picture(out, check);
  made.caption = compared ? "golden, result, difference" : "result";
  return made;
}

std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm moment{};
  gmtime_r(&seconds, &moment);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &moment);
  return text;
}

std::vector<CheckCase> chosen_cases(const CheckOptions& options) {
  std::vector<CheckCase> cases = read_check_folder(options.folder);
  std::string names;
  for (const CheckCase& check : cases) names += (names.empty() ? "" : ", ") + check.name;
  std::erase_if(cases, [&](const CheckCase& check) { return !matches(check.name, options.only); });
  if (cases.empty())
    throw Error("--only " + options.only, "matches no scene of " + options.folder, "expected a part of " + names);
  return cases;
}

// Before the scenes are simulated, which takes long.
void say_missing_goldens(const std::vector<CheckCase>& cases) {
  std::size_t count = 0;
  std::string names;
  for (const CheckCase& check : cases) {
    if (missing_goldens(check.options.goldens()).empty()) continue;
    names += (count++ > 0 ? ", " : "") + check.name;
  }
  if (count > 0)
    std::cerr << "fascia: no golden yet for " << count << " of " << plural(cases.size(), "scene") << ": " << names
              << "; --update makes them\n";
}

// Says on stderr what runs if no result has come for some time, so that a log shows that the work goes on.
class Patience {
 public:
  void result() { last_ = Clock::now(); }
  void wait(const std::vector<CheckCase>& cases, std::size_t first, std::size_t next) {
    constexpr std::chrono::seconds kSilence(15);
    if (Clock::now() - last_ < kSilence) return;
    last_ = Clock::now();
    std::cerr << "fascia: " << first << " of " << plural(cases.size(), "scene") << " done, now " << cases[first].name;
    if (next > first + 1) std::cerr << " and " << next - first - 1 << " more";
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    std::cerr << ", " << std::lround(seconds) << " s\n" << std::flush;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

// Scenes in separate processes, `jobs` at a time. `done` gets their results in the order of the folder, and returns
// whether the check goes on.
void run_checks(const std::vector<CheckCase>& cases, const CheckOptions& options,
                const std::function<bool(const CheckCase&, const CheckResult&)>& done) {
  constexpr int kWait = 20;  // [ms]
  std::vector<std::unique_ptr<CheckRun>> runs(cases.size());
  std::size_t next = 0, first = 0;  // to begin, to report
  Patience patience;
  while (first < cases.size()) {
    int running = 0;
    for (std::size_t i = first; i < next; ++i) running += !runs[i]->ended(0);
    for (; running < options.jobs && next < cases.size() && !interrupted(); ++running, ++next)
      runs[next] = std::make_unique<CheckRun>(cases[next], options);
    if (first == next) return;  // interrupted
    if (!runs[first]->ended(kWait)) {
      if (!options.quiet) patience.wait(cases, first, next);
      continue;
    }
    patience.result();
    if (!done(cases[first], runs[first]->result())) return;
    runs[first++].reset();
  }
}

// So that scenes that are checked at the same time share the cores.
void share_cores(int jobs) {
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  if (jobs > 1) setenv("LP_NUM_THREADS", std::to_string(std::max(1, cores / jobs)).c_str(), 0);
}

int check_folder(const CheckOptions& options) {
  require_outputs(
      {{"--junit", options.junit, {".xml"}, OutputFile::Takes::all_but_foreign}, {"--html", options.html, {".html"}}});
  const std::vector<CheckCase> cases = chosen_cases(options);
  if (!options.out.empty()) {
    std::error_code ec;
    fs::create_directories(options.out, ec);
    if (ec) throw Error(options.out, "cannot be made: " + ec.message(), "expected a folder that can be written");
  }
  std::size_t name_width = 5;
  for (const CheckCase& check : cases) name_width = std::max(name_width, check.name.size());
  if (!options.quiet) std::cout << row({"scene", "result", "mean", "share", "state", "seconds"}, name_width) << '\n';
  if (!options.quiet && !options.update) say_missing_goldens(cases);
  share_cores(options.jobs);
  std::vector<JunitCase> report;
  std::vector<ReportCase> pages;
  run_checks(cases, options, [&](const CheckCase& check, const CheckResult& result) {
    if (interrupted() && result.verdict == Verdict::error) return false;  // it was not completed
    print(check, result, name_width, options.quiet);
    report.push_back(junit_case(check, result));
    pages.push_back(report_case(check, result, options.out));
    return !interrupted();
  });
  const auto bad = std::count_if(report.begin(), report.end(),
                                 [](const JunitCase& c) { return c.verdict != JunitCase::Verdict::passed; });
  const fs::path folder = fs::path(options.folder).lexically_normal();
  const std::string title = "fascia check " + (folder == "." ? fs::current_path().filename() : folder).string();
  if (!options.junit.empty()) write_file(options.junit, junit_xml(title, now(), report));
  if (!options.html.empty()) write_file(options.html, html_report(title, now(), pages));
  if (interrupted()) return exit_interrupted;
  if (bad > 0 && !options.out.empty())
    std::cout << "new pictures, states and differences are in " << options.out << '\n';
  if (bad > 0 || !options.quiet)
    std::cout << report.size() << (report.size() == 1 ? " scene, " : " scenes, ") << bad << " failed\n";
  return bad > 0 ? exit_failed : exit_done;
}

}  // namespace

void add_check(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App& command = *program.add_subcommand(
      "check", "a folder of scenes against golden pictures and states; exit code 1 where one differs");
  command.add_option("folder", options->folder, "scenes and replays, their goldens beside them, and check.json")
      ->type_name("DIR")
      ->required();
  command.add_flag("--update", options->update,
                   "write the goldens anew and say what changed: look at every picture before you keep it");
  command
      .add_option("--out", options->out, "folder for the new picture, the new state and the difference of what fails")
      ->type_name("DIR");
  command.add_option("--junit", options->junit, "the results for GitLab, Jenkins or GitHub")->type_name("FILE.xml");
  command
      .add_option("--html", options->html,
                  "a report with the goldens, and with --out golden, result and difference of what fails side by side")
      ->type_name("FILE.html");
  command.add_option("--jobs", options->jobs, "scenes that are checked at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command.add_option("--only", options->only, "scenes whose name has such a part; * and ? as in file names")
      ->type_name("PATTERN");
  command.add_option("--timeout", options->timeout, "after which a scene counts as failed")
      ->type_name("SECONDS")
      ->check(CLI::Range(1e-3, 1e7))
      ->capture_default_str();
  add_quality(command, *options);
  add_graphics(command, *options);
  add_examples(
      command,
      {"fascia check assets/check", "fascia check tests/scenes --context osmesa --junit report.xml --out failures",
       "fascia check tests/scenes --only liver --update"},
      "a scene differs or could not be checked");
  command.callback([&invocation, options] {
    options->command_line = invocation.command_line;
    invocation.run = [options] { return check_folder(*options); };
  });
}

}  // namespace fascia
