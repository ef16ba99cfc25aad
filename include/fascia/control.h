// How a program follows and ends long work.
#pragma once
#include <functional>
#include <stop_token>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  struct Control {
    /// Called on the calling thread now and then: the share that is done, 0 to 1, and what comes next. An exception
    /// that it throws ends the work and reaches the caller.
    std::function<void(double share, const char* what)> progress{};
    std::stop_token stop{};  // ends the work soon after a stop is requested, from any thread
  };

}  // namespace api
}  // namespace fascia
