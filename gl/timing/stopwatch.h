// Measures consecutive pieces of GPU work: by timestamps of the device, without waiting; on devices without them, such
// as software renderers, by waiting for every piece and reading the clock.
#pragma once
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "gl/loader.h"

namespace fascia::gl {

class Stopwatch {
 public:
  /// Starts after all earlier commands. Needs a current context, as do the other functions and the destructor.
  explicit Stopwatch(bool timestamps = device().timestamp_bits > 0);
  ~Stopwatch();
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

  /// Ends the piece of work since the last mark.
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
