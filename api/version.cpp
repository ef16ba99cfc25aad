#include "fascia/version.h"

namespace fascia::api {

const char* version() { return FASCIA_VERSION; }

}  // namespace fascia::api
