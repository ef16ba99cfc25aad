// Measures the speed of the device itself, as a reference for the speed of kernels.
#pragma once
#include "app/bench/table.h"
#include "gl/program.h"

namespace fascia {

struct DeviceSpeed {
  double copy_gigabytes_per_s = 0;  // from a large buffer to another; read and written bytes together
  double dispatch_us = 0;           // a kernel of one work group that waits for the one before it
  double dispatch_submit_us = 0;    // the part that occupies the CPU
  double read_us = 0;               // four bytes, while the device is idle
};

/// Medians. `bytes`: of the buffer that is copied. Throws Error.
DeviceSpeed measure_device(gl::ProgramCache& programs, std::size_t bytes);
Table table_of(const DeviceSpeed& speed);

}  // namespace fascia
