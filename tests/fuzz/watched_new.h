// Every single allocation of the program is measured.
#pragma once
#include <cstddef>

namespace fascia::test {

extern std::size_t largest_allocation;  // [bytes] since it was last set to 0

}  // namespace fascia::test
