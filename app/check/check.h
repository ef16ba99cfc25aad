// Checks one scene of a folder: it is stepped, drawn and compared in a separate process.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/check/check_folder.h"

namespace fascia {

struct CheckOptions : CommonOptions {
  std::string folder;
  std::string out;    // folder for the results of failures; empty: none
  std::string junit;  // XML
  std::string only;   // pattern
  bool update = false;
  double timeout = 600;  // [s] of a scene
};

struct CheckResult {
  enum class Verdict { passed, failed, error, updated };
  Verdict verdict = Verdict::error;
  std::vector<std::string> lines;                // findings, or updates
  std::optional<double> mean, share, deviation;  // as in GoldenLimits; absent: not compared
  double seconds = 0;
  std::string said;
};

/// A scene that does not open, crashes or hangs is a result, not an exception.
CheckResult run_check(const CheckCase& check, const CheckOptions& options);

}  // namespace fascia
