#include "render/gl/timer.h"

namespace fascia::gl {

Timer::Timer() : software_(device().software) {
  if (!software_) GenQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

Timer::~Timer() {
  if (!software_) DeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

void Timer::begin() {
  if (software_) {
    Finish();
    start_ = std::chrono::steady_clock::now();
    return;
  }
  collect();
  measuring_ =
      pending_ < kPairs;  // else the GPU is far behind: this one goes unmeasured rather than waited for
  if (measuring_) QueryCounter(queries_[2 * next_], GL_TIMESTAMP);
}

void Timer::end() {
  if (software_) {
    Finish();
    milliseconds_ =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    return;
  }
  if (!measuring_) return;
  QueryCounter(queries_[2 * next_ + 1], GL_TIMESTAMP);
  next_ = (next_ + 1) % kPairs;
  ++pending_;
}

void Timer::collect() {
  while (pending_ > 0) {
    const unsigned oldest = (next_ + kPairs - pending_) % kPairs;
    GLint ready = 0;
    GetQueryObjectiv(queries_[2 * oldest + 1], GL_QUERY_RESULT_AVAILABLE, &ready);
    if (!ready) return;
    GLuint64 from = 0, to = 0;
    GetQueryObjectui64v(queries_[2 * oldest], GL_QUERY_RESULT, &from);
    GetQueryObjectui64v(queries_[2 * oldest + 1], GL_QUERY_RESULT, &to);
    milliseconds_ = static_cast<double>(to - from) * 1e-6;
    --pending_;
  }
}

}  // namespace fascia::gl
