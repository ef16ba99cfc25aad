// Tells somebody who waits how far something long has come.
#pragma once
#include <functional>

namespace fascia {

using Progress = std::function<void(double share, const char* what)>;  // share 0 to 1, done so far; what comes next

inline void report(const Progress& progress, double share, const char* what) {
  if (progress) progress(share, what);
}

}  // namespace fascia
