#include "render/gl/loader.h"

#include <cstring>
#include <stdexcept>
#include <string>

namespace fascia::gl {

#define X(name) decltype(&::gl##name) name = nullptr;
FASCIA_GL_FUNCTIONS(X)
#undef X

}  // namespace fascia::gl
