// KHR_debug messages to a log: a place to look when a driver complains.
#pragma once
#include <functional>
#include <string>

namespace fascia::gl {

/// Installs a message callback in the current context; notifications are dropped. `sink` gets one line per message.
void log_debug_messages(std::function<void(const std::string&)> sink);

}  // namespace fascia::gl
