// What the process holds of the machine's memory.
#pragma once
#include <cstddef>

namespace fascia {

std::size_t resident_bytes();  // 0 where the system does not tell

}  // namespace fascia
