#include "api/error.h"

namespace fascia::api {

Error::Error(const std::string& message) : std::runtime_error(message) {}
Error::Error(const std::string& where, const std::string& what, const std::string& expected)
    : Error(fascia::Error(where, what, expected).what()) {}
Error::~Error() = default;

Interrupted::Interrupted(const std::string& message) : Error(message) {}
Interrupted::~Interrupted() = default;

ContextLost::ContextLost(const std::string& message) : Error(message) {}
ContextLost::~ContextLost() = default;

}  // namespace fascia::api
