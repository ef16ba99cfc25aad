#include "app/cli/name_pattern.h"

#include <fnmatch.h>

namespace fascia {

bool matches(const std::string& name, const std::string& pattern) {
  return pattern.empty() || fnmatch(("*" + pattern + "*").c_str(), name.c_str(), 0) == 0;
}

}  // namespace fascia
