// The memory in use by the process.
#pragma once
#include <cstddef>

namespace fascia {

std::size_t resident_bytes();  // 0 if the system does not report it

}  // namespace fascia
