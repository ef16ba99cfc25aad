// Matches the pattern of --only: a part of a name, in which * and ? have their meaning for file names.
#pragma once
#include <string>

namespace fascia {

/// An empty pattern matches every name.
bool matches(const std::string& name, const std::string& pattern);

}  // namespace fascia
