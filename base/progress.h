// How far long work has come. The callback may throw, which ends the work: that is how a user interrupts it.
#pragma once
#include <functional>

namespace fascia {

using Progress = std::function<void(double share, const char* what)>;  // share 0 to 1, done so far; what comes next

inline void report(const Progress& progress, double share, const char* what) {
  if (progress) progress(share, what);
}

/// For work that is the part from `begin` to `end` of a longer one.
inline Progress part_of(const Progress& progress, double begin, double end) {
  if (!progress) return {};
  return [progress, begin, end](double share, const char* what) { progress(begin + (end - begin) * share, what); };
}

}  // namespace fascia
