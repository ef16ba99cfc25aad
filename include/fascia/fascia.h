// All public headers of libfascia, a real-time simulator of soft tissue on the GPU.
//
// Link the CMake target fascia::fascia (find_package(fascia)) or use the flags of pkg-config fascia.
#pragma once
#include "fascia/context.h"
#include "fascia/control.h"
#include "fascia/diagnostics.h"
#include "fascia/error.h"
#include "fascia/material.h"
#include "fascia/mesh.h"
#include "fascia/scene.h"
#include "fascia/settings.h"
#include "fascia/simulation.h"
#include "fascia/state.h"
#include "fascia/version.h"
