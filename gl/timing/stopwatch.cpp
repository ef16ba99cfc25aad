#include "gl/timing/stopwatch.h"

#include "gl/timing/timestamps.h"

namespace fascia::gl {

Stopwatch::Stopwatch(bool timestamps) : timestamps_(timestamps) {
  Finish();
  stamp();
}

Stopwatch::~Stopwatch() { DeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data()); }

void Stopwatch::stamp() {
  if (timestamps_) {
    GenQueries(1, &queries_.emplace_back());
    QueryCounter(queries_.back(), GL_TIMESTAMP);
  } else {
    Finish();
    times_.push_back(std::chrono::steady_clock::now());
  }
}

void Stopwatch::mark(std::string name) {
  stamp();
  names_.push_back(std::move(name));
}

std::vector<std::pair<std::string, double>> Stopwatch::laps() const {
  std::vector<std::pair<std::string, double>> laps;
  const auto nanoseconds_at = [&](std::size_t i) {
    GLuint64 at = 0;
    GetQueryObjectui64v(queries_[i], GL_QUERY_RESULT, &at);
    return at;
  };
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const double ms = timestamps_ ? milliseconds_between(nanoseconds_at(i), nanoseconds_at(i + 1))
                                  : std::chrono::duration<double, std::milli>(times_[i + 1] - times_[i]).count();
    laps.emplace_back(names_[i], ms);
  }
  return laps;
}

}  // namespace fascia::gl
