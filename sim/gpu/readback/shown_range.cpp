#include "sim/gpu/readback/shown_range.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "shaders/shared/types.h"

namespace fascia {
namespace {

constexpr double kUsualShare = 0.98;
constexpr std::size_t kMostRanked = 65536;  // of larger meshes every n-th vertex is ranked: a millisecond of the CPU

}  // namespace

ShownRange::ShownRange(const gl::Buffer& positions, std::uint32_t vertex_count)
    : positions_(positions), staging_(gl::Buffer::staging("range_staging", vertex_count * sizeof(shared::vec4))) {}

void ShownRange::request() {
  staging_.copy(positions_, staging_.bytes());
  fence_.set();
}

std::optional<ShownValues> ShownRange::take(bool wait) {
  if (!fence_.take(wait)) return std::nullopt;
  const std::vector<shared::vec4> shown = staging_.read<shared::vec4>();
  const std::size_t spacing = (shown.size() + kMostRanked - 1) / kMostRanked;
  ShownValues values{HUGE_VAL, -HUGE_VAL, 0};
  std::vector<float> ranked;  // distances from the middle
  ranked.reserve(shown.size() / spacing + 1);
  for (std::size_t v = 0; v < shown.size(); ++v) {
    const float scalar = shown[v].w;
    if (!std::isfinite(scalar)) continue;
    values.smallest = std::min<double>(values.smallest, scalar);
    values.largest = std::max<double>(values.largest, scalar);
    if (v % spacing == 0) ranked.push_back(std::abs(scalar - static_cast<float>(middle_)));
  }
  if (ranked.empty()) return std::nullopt;
  const auto place = static_cast<std::ptrdiff_t>(std::ceil(kUsualShare * static_cast<double>(ranked.size()))) - 1;
  std::nth_element(ranked.begin(), ranked.begin() + place, ranked.end());
  values.usual = ranked[static_cast<std::size_t>(place)];
  return values;
}

}  // namespace fascia
