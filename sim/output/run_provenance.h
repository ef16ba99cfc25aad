// The origin of a picture, a video or a table: version, renderer, mesh, parameters, command line.
#pragma once
#include <string>

#include "base/provenance.h"
#include "sim/model/model.h"
#include "sim/scene/scene.h"

namespace fascia {

Provenance provenance_of(const Scene& scene, const Model& model, const std::string& renderer,
                         const std::string& command_line, long step, double time);

}  // namespace fascia
