// Converts a scene from arrays to the library's own scene and model.
#pragma once
#include "fascia/scene.h"
#include "sim/model/model.h"
#include "sim/scene/scene.h"

namespace fascia::api {

struct BuiltScene {
  fascia::Scene scene;
  Model model;
};

/// Throws Error of either kind for inconsistent input (fascia/scene.h).
BuiltScene build(const Scene& scene);

}  // namespace fascia::api
