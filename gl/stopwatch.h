// How long pieces of GPU work take that follow each other: by timestamps of the device, which nothing waits for; where
// there are none, as on software renderers, every piece is waited for and the clock on the wall read.
#pragma once
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "gl/loader.h"

namespace fascia::gl {

class Stopwatch {
 public:
  /// Starts after all work that was asked for before. Needs a current context, as do the others and the destructor.
  explicit Stopwatch(bool timestamps = device().timestamp_bits > 0);
  ~Stopwatch();
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

  /// The piece that was asked for since the last mark ends here.
  void mark(std::string name);
  /// Milliseconds of every piece, by the names of their marks, in their order. Waits for the device.
  std::vector<std::pair<std::string, double>> laps() const;

 private:
  void stamp();
  const bool timestamps_;
  std::vector<std::string> names_;
  std::vector<GLuint> queries_;                               // [names + 1] with timestamps
  std::vector<std::chrono::steady_clock::time_point> times_;  // [names + 1] without
};

}  // namespace fascia::gl
