// Results as JUnit XML, which GitLab, Jenkins and GitHub show as a table.
#pragma once
#include <string>
#include <vector>

namespace fascia {

struct JunitCase {
  enum class Verdict { passed, failed, error };  // error: there was nothing to judge
  std::string name;
  Verdict verdict = Verdict::passed;
  double seconds = 0;
  std::string message;  // of a failure or error: one line
  std::string details;  // all lines
  std::string output;   // what the work said
};

/// testsuites > testsuite > testcase. `timestamp` as in 2026-01-31T12:00:00. What XML cannot hold is replaced by "?".
std::string junit_xml(const std::string& suite, const std::string& timestamp, const std::vector<JunitCase>& cases);

}  // namespace fascia
