#include "app/session/progress_lines.h"

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
constexpr double kLongestSilence = 30;               // [s] between lines of steps
constexpr double kLeastShare = 0.02;                 // completed, before a remaining time is estimated

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void print_line(const std::string& name, double share, const char* what, double seconds) {
  char rest[64] = "";
  if (share >= kLeastShare && share < 1)
    std::snprintf(rest, sizeof rest, ", about %.0f s left", std::ceil(seconds * (1 - share) / share));
  char done[32];
  constexpr double kRounding = 1e-9;  // 7 of 10 steps are 70 %
  std::snprintf(done, sizeof done, "%.0f %%", std::floor(100 * share + kRounding));
  std::cerr << "fascia: " + name + ": " + what + ", " + done + rest + "\n" << std::flush;
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace

// The states are shared, because parts of the work copy the callbacks.

Progress opening_progress(const std::string& name) {
  struct Clocks {
    Clock::time_point start = Clock::now();
    double next = kFirstLine;
  };
  return [name = file_name(name), clocks = std::make_shared<Clocks>()](double share, const char* what) {
    const double seconds = seconds_since(clocks->start);
    if (seconds < clocks->next) return;
    clocks->next = seconds + kBetweenLines;
    print_line(name, share, what, seconds);
  };
}

Progress stepping_progress(const std::string& name) {
  struct Said {
    Clock::time_point start = Clock::now();
    int tenths = 0;
    double time = 0;  // [s]
  };
  return [name = file_name(name), said = std::make_shared<Said>()](double share, const char* what) {
    const double seconds = seconds_since(said->start);
    constexpr double kRounding = 1e-9;
    const int tenths = static_cast<int>(10 * share + kRounding);
    const bool further = tenths > said->tenths && tenths < 10, silent = seconds - said->time < kLongestSilence;
    said->tenths = tenths;
    if (seconds < kFirstLine || (!further && silent)) return;
    said->time = seconds;
    print_line(name, share, what, seconds);
  };
}

}  // namespace fascia
