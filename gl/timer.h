// Elapsed milliseconds of GPU work: pairs of timestamps on a GPU (read some frames late, never waiting; two
// timers may overlap), wall clock around glFinish where there are none.
#pragma once
#include <array>
#include <chrono>
#include <optional>

#include "gl/loader.h"

namespace fascia::gl {

class Timer {
 public:
  /// What was measured, with what was said of it when it ended: it is told some frames later.
  struct Measurement {
    double milliseconds;
    int steps;      // that were made meanwhile
    bool compiled;  // kernels, too: the next ones will be faster
  };

  Timer();
  ~Timer();
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;
  void begin();
  void end(int steps = 1, bool compiled = false);
  /// The oldest finished measurement that was not taken yet.
  std::optional<Measurement> take();

 private:
  static constexpr unsigned kPairs = 4;  // measurements that may be under way
  const bool timestamps_;
  std::array<GLuint, 2 * kPairs> queries_{};  // begin, end, begin, end, ...
  std::array<Measurement, kPairs> measurements_{};
  unsigned next_ = 0, pending_ = 0;  // pair to use next; pairs not taken yet
  bool measuring_ = false;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace fascia::gl
