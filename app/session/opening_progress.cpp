#include "app/session/opening_progress.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

namespace fascia {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFirstLine = 3, kBetweenLines = 5;  // [s]
constexpr double kLeastShare = 0.02;                 // completed, before a remaining time is estimated

std::string line_of(const std::string& name, double share, const char* what, double seconds) {
  char rest[64] = "";
  if (share >= kLeastShare)
    std::snprintf(rest, sizeof rest, ", about %.0f s left", std::ceil(seconds * (1 - share) / share));
  char done[32];
  std::snprintf(done, sizeof done, "%.0f %%", std::floor(100 * share));
  return "fascia: " + name + ": " + what + ", " + done + rest + "\n";
}

}  // namespace

Progress opening_progress(const std::string& name) {
  struct Clocks {
    Clock::time_point start = Clock::now();
    double next = kFirstLine;
  };
  // Shared, because parts of the work copy the callback.
  return [name = std::filesystem::path(name).filename().string(), clocks = std::make_shared<Clocks>()](
             double share, const char* what) {
    const double seconds = std::chrono::duration<double>(Clock::now() - clocks->start).count();
    if (seconds < clocks->next) return;
    clocks->next = seconds + kBetweenLines;
    std::cerr << line_of(name, share, what, seconds) << std::flush;
  };
}

}  // namespace fascia
