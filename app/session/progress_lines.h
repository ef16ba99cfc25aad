// Reports on stderr the progress and the remaining time of long work: a plain line now and then, for logs as for
// terminals.
#pragma once
#include <string>

#include "base/progress.h"

namespace fascia {

/// Of opening a large file: prints a line every few seconds, the first after some seconds, each with the name of the
/// file.
Progress opening_progress(const std::string& name);

/// Of steps and frames: prints a line after each tenth of the work, or after half a minute without one. Work that takes
/// a few seconds prints nothing.
Progress stepping_progress(const std::string& name);

}  // namespace fascia
