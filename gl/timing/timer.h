// Elapsed milliseconds of GPU work: pairs of timestamps on a GPU (read some frames late, without waiting; two timers
// may overlap), wall clock around glFinish on devices without them.
#pragma once
#include <array>
#include <chrono>
#include <optional>

#include "gl/loader.h"

namespace fascia::gl {

class Timer {
 public:
  /// A measurement with the data given at its end; it is available some frames later.
  struct Measurement {
    double milliseconds;
    int steps;      // number during the measurement
    bool compiled;  // whether kernels were compiled, too: the next measurements will be faster
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
  static constexpr unsigned kPairs = 4;  // measurements that may be pending
  const bool timestamps_;
  std::array<GLuint, 2 * kPairs> queries_{};  // begin, end, begin, end, ...
  std::array<Measurement, kPairs> measurements_{};
  unsigned next_ = 0, pending_ = 0;  // pair to use next; pairs not taken yet
  bool measuring_ = false;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace fascia::gl
