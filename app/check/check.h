// One scene of a checked folder, stepped, drawn and compared in a process of its own.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/check/check_folder.h"

namespace fascia {

struct CheckOptions : CommonOptions {
  std::string folder;
  std::string out;    // folder for what failures leave; empty: they leave nothing
  std::string junit;  // XML
  std::string only;   // pattern
  bool update = false;
  double timeout = 600;  // [s] of a scene
};

struct CheckResult {
  enum class Verdict { passed, failed, error, updated };
  Verdict verdict = Verdict::error;
  std::vector<std::string> lines;                // what was found, or what changed
  std::optional<double> mean, share, deviation;  // as in GoldenLimits; absent: not compared
  double seconds = 0;
  std::string said;
};

/// Throws nothing for a scene that does not open, crashes or hangs: that is a result.
CheckResult run_check(const CheckCase& check, const CheckOptions& options);

}  // namespace fascia
