#include "gl/timing/timer.h"

#include "gl/timing/timestamps.h"

namespace fascia::gl {

Timer::Timer() : timestamps_(device().timestamp_bits > 0) {
  if (timestamps_) GenQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

Timer::~Timer() {
  if (timestamps_) DeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

void Timer::begin() {
  measuring_ = pending_ < kPairs;  // else the GPU is behind, or no result is taken: not measured, to avoid a wait
  if (!measuring_) return;
  if (timestamps_) {
    QueryCounter(queries_[2 * next_], GL_TIMESTAMP);
  } else {
    Finish();
    start_ = std::chrono::steady_clock::now();
  }
}

void Timer::end(int steps, bool compiled) {
  if (!measuring_) return;
  Measurement& measurement = measurements_[next_] = {0, steps, compiled};
  if (timestamps_) {
    QueryCounter(queries_[2 * next_ + 1], GL_TIMESTAMP);
  } else {
    Finish();
    measurement.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }
  next_ = (next_ + 1) % kPairs;
  ++pending_;
}

std::optional<Timer::Measurement> Timer::take() {
  while (pending_ > 0) {
    const unsigned oldest = (next_ + kPairs - pending_) % kPairs;
    Measurement& measurement = measurements_[oldest];
    if (timestamps_) {
      GLint ready = 0;
      GetQueryObjectiv(queries_[2 * oldest + 1], GL_QUERY_RESULT_AVAILABLE, &ready);
      if (!ready) return std::nullopt;
      GLuint64 from = 0, to = 0;
      GetQueryObjectui64v(queries_[2 * oldest], GL_QUERY_RESULT, &from);
      GetQueryObjectui64v(queries_[2 * oldest + 1], GL_QUERY_RESULT, &to);
      measurement.milliseconds = milliseconds_between(from, to);
    }
    --pending_;
    if (measurement.milliseconds > 0) return measurement;
  }
  return std::nullopt;
}

}  // namespace fascia::gl
