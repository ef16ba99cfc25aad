// Converts materials of the public interface to the library's own, and back.
#pragma once
#include <string>

#include "fascia/material.h"
#include "sim/material/material.h"

namespace fascia::api {

/// Throws Error "where.young_modulus: ..." for a value out of range or an unknown law.
fascia::Material checked(const Material& material, const std::string& where);
Material shown(const fascia::Material& material);

}  // namespace fascia::api
