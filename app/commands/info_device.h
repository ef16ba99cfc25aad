// fascia info --device: what the graphics device is, why it was taken, and whether it computes what it should.
#pragma once
#include "app/cli/options.h"

namespace fascia {

/// Prints the report; the exit code. `--device N`: options.device.
int inspect_device(const CommonOptions& options);

}  // namespace fascia
