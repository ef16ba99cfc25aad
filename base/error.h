// The only exception type of fascia: its text is the line that a user reads on stderr.
#pragma once
#include <stdexcept>
#include <string>

namespace fascia {

/// "where: what; what was expected". `where` is a path, `path:line`, `path:line:column` or `path: json.path`.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
  Error(const std::string& where, const std::string& what, const std::string& expected)
      : std::runtime_error(where + ": " + what + (expected.empty() ? "" : "; " + expected)) {}
};

}  // namespace fascia
