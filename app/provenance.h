// What made a picture, a video or a table: version, renderer, mesh, parameters, command line.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "sim/model.h"
#include "sim/scene.h"

namespace fascia {

using Provenance = std::vector<std::pair<std::string, std::string>>;  // keyword, text

Provenance provenance_of(const Scene& scene, const Model& model, const std::string& renderer,
                         const std::string& command_line, long step, double time);

}  // namespace fascia
