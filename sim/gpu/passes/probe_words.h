// What the small kernel leaves in its buffer that finds out whether a device computes (compute_probe.h).
#pragma once
#include <array>
#include <cstdint>

namespace fascia {

constexpr std::array<std::uint32_t, 4> kProbeWords{0x3f9d70a4, 0x00c0ffee, 0x5eed0001, 0xfffffff7};
constexpr std::uint32_t kProbeRepeats = 64;

}  // namespace fascia
