// Progress and cancellation of long work, such as opening a scene or reading a mesh.
#pragma once
#include <functional>
#include <stop_token>

#include "fascia/export.h"

namespace fascia {
FASCIA_INLINE namespace api {
  /// Follows long work and ends it early. A default Control does neither.
  struct Control {
    /// The library calls this function at intervals on the calling thread. `share` is the completed share of the work,
    /// 0 to 1, and `what` names the next part. An exception that the function throws ends the work and reaches the
    /// caller.
    std::function<void(double share, const char* what)> progress{};
    /// The work ends soon after a stop is requested, from any thread, and the call throws Interrupted.
    std::stop_token stop{};
  };

}  // namespace api
}  // namespace fascia
