// Writes results as JUnit XML, which GitLab, Jenkins and GitHub display as a table.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace fascia {

struct JunitCase {
  enum class Verdict { passed, failed, error };  // error: no result to judge
  std::string name;
  Verdict verdict = Verdict::passed;
  double seconds = 0;
  std::string message;                                          // of a failure or error: one line
  std::string details;                                          // all lines
  std::string output;                                           // of the scene
  std::vector<std::pair<std::string, double>> properties = {};  // measured and allowed differences, by name
};

/// testsuites > testsuite > testcase. `timestamp` as in 2026-01-31T12:00:00. Characters that XML cannot represent are
/// replaced by "?".
std::string junit_xml(const std::string& suite, const std::string& timestamp, const std::vector<JunitCase>& cases);

}  // namespace fascia
