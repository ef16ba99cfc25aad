// What --only means: a part of a name, in which * and ? stand for what they stand for in file names.
#pragma once
#include <string>

namespace fascia {

/// An empty pattern matches all.
bool matches(const std::string& name, const std::string& pattern);

}  // namespace fascia
