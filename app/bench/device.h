// What the device itself can do, for judging what kernels make of it.
#pragma once
#include "app/bench/table.h"
#include "gl/program.h"

namespace fascia {

struct DeviceSpeed {
  double copy_gigabytes_per_s = 0;  // a large buffer to another one; read and written bytes together
  double dispatch_us = 0;           // a kernel of one work group that waits for the one before it
  double dispatch_submit_us = 0;    // what of it the CPU is busy with
  double read_us = 0;               // four bytes, when the device has nothing else to do
};

/// Medians. `bytes`: of the buffer that is copied. Throws Error.
DeviceSpeed measure_device(gl::ProgramCache& programs, std::size_t bytes);
Table table_of(const DeviceSpeed& speed);

}  // namespace fascia
