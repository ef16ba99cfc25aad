// Reports on stderr the progress and the remaining time of opening a large file.
#pragma once
#include <string>

#include "base/progress.h"

namespace fascia {

/// Prints a line at intervals, the first after some seconds, each with the name of the file.
Progress opening_progress(const std::string& name);

}  // namespace fascia
