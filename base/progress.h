// Progress of long work. The callback may throw, which ends the work: a user's interruption does so.
#pragma once
#include <functional>

namespace fascia {

using Progress = std::function<void(double share, const char* what)>;  // share 0 to 1, done so far; `what` comes next

inline void report(const Progress& progress, double share, const char* what) {
  if (progress) progress(share, what);
}

/// Progress for the part from `begin` to `end` of longer work.
inline Progress part_of(const Progress& progress, double begin, double end) {
  if (!progress) return {};
  return [progress, begin, end](double share, const char* what) { progress(begin + (end - begin) * share, what); };
}

}  // namespace fascia
