// fascia check: compares a folder of scenes with their goldens, as a table and as JUnit XML for CI.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <iostream>

#include "app/check/check.h"
#include "app/check/junit.h"
#include "app/cli/command_line.h"
#include "app/cli/name_pattern.h"
#include "app/cli/output_files.h"
#include "app/commands/command.h"
#include "app/golden/tolerance.h"
#include "base/error.h"
#include "base/file.h"
#include "base/interrupt.h"

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

void print(const CheckCase& check, const CheckResult& result, std::size_t name_width, bool quiet) {
  const bool good = result.verdict == Verdict::passed || result.verdict == Verdict::updated;
  if (quiet && good) return;
  char seconds[24];
  std::snprintf(seconds, sizeof seconds, "%.1f", result.seconds);
  std::cout << row({check.name, name_of(result.verdict), cell(result.mean), cell(result.share), cell(result.deviation),
                    seconds},
                   name_width)
            << '\n';
  for (const std::string& line : result.lines) std::cout << "    " << line << '\n';
  std::cout.flush();
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

int check_folder(const CheckOptions& options) {
  require_outputs({{"--junit", options.junit, {".xml"}, OutputFile::Takes::all_but_foreign}});
  const std::vector<CheckCase> cases = chosen_cases(options);
  if (!options.out.empty()) {
    std::error_code ec;
    fs::create_directories(options.out, ec);
    if (ec) throw Error(options.out, "cannot be made: " + ec.message(), "expected a folder that can be written");
  }
  std::size_t name_width = 5;
  for (const CheckCase& check : cases) name_width = std::max(name_width, check.name.size());
  if (!options.quiet) std::cout << row({"scene", "result", "mean", "share", "state", "seconds"}, name_width) << '\n';
  std::vector<JunitCase> report;
  for (const CheckCase& check : cases) {
    const CheckResult result = run_check(check, options);
    if (interrupted() && result.verdict == Verdict::error) break;  // it was not completed
    print(check, result, name_width, options.quiet);
    report.push_back(junit_case(check, result));
    if (interrupted()) break;
  }
  const auto bad = std::count_if(report.begin(), report.end(),
                                 [](const JunitCase& c) { return c.verdict != JunitCase::Verdict::passed; });
  if (!options.junit.empty())
    write_file(options.junit,
               junit_xml("fascia check " + fs::path(options.folder).lexically_normal().string(), now(), report));
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
  command.add_option("--only", options->only, "scenes whose name has such a part; * and ? as in file names")
      ->type_name("PATTERN");
  command.add_option("--timeout", options->timeout, "after which a scene counts as failed")
      ->type_name("SECONDS")
      ->check(CLI::Range(1e-3, 1e7))
      ->capture_default_str();
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
