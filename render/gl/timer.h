// Elapsed milliseconds of GPU work: pairs of timestamps on a GPU (read some frames late, never waiting; two
// timers may overlap), wall clock around glFinish on software renderers, whose queries are nonsense.
#pragma once
#include <array>
#include <chrono>

#include "render/gl/loader.h"

namespace fascia::gl {

class Timer {
 public:
  Timer();
  ~Timer();
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;
  void begin();
  void end();
  double milliseconds() const { return milliseconds_; }  // latest finished measurement

 private:
  static constexpr unsigned kPairs = 4;  // measurements that may be under way
  void collect();
  std::array<GLuint, 2 * kPairs> queries_{};  // begin, end, begin, end, ...
  unsigned next_ = 0, pending_ = 0;           // pair to use next; pairs not read yet
  bool measuring_ = false;
  std::chrono::steady_clock::time_point start_;
  double milliseconds_ = 0;
  bool software_;
};

}  // namespace fascia::gl
