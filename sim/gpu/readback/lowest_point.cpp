#include "sim/gpu/readback/lowest_point.h"

#include <algorithm>

#include "sim/gpu/passes/reduction.h"

namespace fascia {

LowestPoint::LowestPoint(gl::ProgramCache& programs, const gl::Buffer& positions,
                         const std::vector<std::uint32_t>& vertices)
    : partial_count_(lanes_read_back(static_cast<std::uint32_t>(vertices.size()), 1024)),
      vertices_("drawn_vertices", vertices),
      partials_("lowest_partials", partial_count_ * sizeof(float)),
      staging_(gl::Buffer::staging("lowest_staging", partials_.bytes())),
      pass_(programs.compute("sim/readback/lowest_point.comp"),
            {{"position", &positions}, {"drawn_vertex", &vertices_}, {"lowest_partials", &partials_}}, partial_count_,
            {{"drawn_count", static_cast<std::uint32_t>(vertices.size())}}) {}

void LowestPoint::request() {
  pass_.run();
  staging_.copy(partials_, partials_.bytes());
  fence_.set();
}

std::optional<double> LowestPoint::take(bool wait) {
  if (!fence_.take(wait)) return std::nullopt;
  const std::vector<float> partials = staging_.read<float>();
  const float lowest = *std::min_element(partials.begin(), partials.end());
  if (lowest > 3.0e38f) return std::nullopt;
  return lowest;
}

}  // namespace fascia
