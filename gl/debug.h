// Writes KHR_debug messages to a log, to diagnose driver complaints.
#pragma once
#include <functional>
#include <string>

namespace fascia::gl {

/// Sends the current context's messages to `sink`, one line each; notifications are dropped. There is one sink for all
/// contexts of the process: the latest.
void log_debug_messages(std::function<void(const std::string&)> sink);

}  // namespace fascia::gl
