#include <string>

#include "fascia/version.h"

TEST_CASE("The library and its headers have the same version") {
  const std::string headers = std::to_string(FASCIA_VERSION_MAJOR) + "." + std::to_string(FASCIA_VERSION_MINOR) + "." +
                              std::to_string(FASCIA_VERSION_PATCH);
  CHECK(fascia::version() == headers);
}
