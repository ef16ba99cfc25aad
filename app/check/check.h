// Checks one scene of a folder: it is stepped, drawn and compared in a separate process.
#pragma once
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/check/check_folder.h"
#include "app/system/child_process.h"

namespace fascia {

struct CheckOptions : CommonOptions {
  std::string folder;
  std::string out;    // folder for the results of failures; empty without one
  std::string junit;  // XML
  std::string html;   // a report with pictures
  std::string only;   // pattern
  bool update = false;
  double timeout = 600;  // [s] per scene
  int jobs = 1;          // scenes checked at a time
};

struct CheckResult {
  enum class Verdict { passed, failed, error, updated };
  Verdict verdict = Verdict::error;
  std::vector<std::string> lines;                         // findings, or updates
  std::optional<double> mean, share, deviation, contact;  // as in GoldenLimits; absent: not compared
  GoldenLimits limits;                                    // of the comparison
  double seconds = 0;
  std::string said;
};

/// A running check. A scene that does not open, crashes or hangs is a result, not an exception.
class CheckRun {
 public:
  CheckRun(const CheckCase& check, const CheckOptions& options);
  bool ended(int wait_ms);     // waits at most `wait_ms`
  CheckResult result() const;  // once it has ended

 private:
  using Clock = std::chrono::steady_clock;
  bool update_;
  GoldenLimits limits_;  // those of the options
  Clock::time_point start_ = Clock::now();
  double seconds_ = 0;
  std::unique_ptr<ChildProcess> child_;
};

/// The files of a failed case in the folder `out`: the new picture, the new state, and both pictures with their
/// difference.
std::filesystem::path new_picture(const std::filesystem::path& out, const CheckCase& check);
std::filesystem::path new_state(const std::filesystem::path& out, const CheckCase& check);
std::filesystem::path difference(const std::filesystem::path& out, const CheckCase& check);

}  // namespace fascia
