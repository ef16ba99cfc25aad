// On stderr: how far a file that takes long to open has come, and how long it takes still.
#pragma once
#include <string>

#include "base/progress.h"

namespace fascia {

/// A line now and then, the first after some seconds, each with the name of what is opened.
Progress opening_progress(const std::string& name);

}  // namespace fascia
