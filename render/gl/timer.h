// Elapsed milliseconds of GPU work: timer queries on a GPU (read some frames late, never waiting), wall clock around glFinish on
// software renderers, whose queries are nonsense.
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
  std::array<GLuint, 4> queries_{};
  unsigned next_ = 0, pending_ = 0;
  std::chrono::steady_clock::time_point start_;
  double milliseconds_ = 0;
  bool software_;
};

}  // namespace fascia::gl
