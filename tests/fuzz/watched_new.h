// Measures every single allocation of the program.
#pragma once
#include <cstddef>

namespace fascia::test {

extern std::size_t largest_allocation;  // [bytes] since it was last reset to 0

}  // namespace fascia::test
