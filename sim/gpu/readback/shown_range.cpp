#include "sim/gpu/readback/shown_range.h"

#include <algorithm>

#include "shaders/shared/types.h"
#include "sim/gpu/passes/reduction.h"

namespace fascia {

ShownRange::ShownRange(gl::ProgramCache& programs, const gl::Buffer& positions, std::uint32_t vertex_count)
    : partial_count_(lanes_read_back(vertex_count, 1024)),
      partials_("range_partials", partial_count_ * sizeof(shared::vec4)),
      staging_(gl::Buffer::staging("range_staging", partials_.bytes())),
      pass_(programs.compute("sim/readback/shown_range.comp"),
            {{"position", &positions}, {"range_partials", &partials_}}, partial_count_,
            {{"vertex_count", vertex_count}}) {}

void ShownRange::request() {
  pass_.run();
  staging_.copy(partials_, partials_.bytes());
  fence_.set();
}

std::optional<Eigen::Vector2d> ShownRange::take(bool wait) {
  if (!fence_.take(wait)) return std::nullopt;
  Eigen::Vector2d range(3.4e38, -3.4e38);
  for (const shared::vec4& p : staging_.read<shared::vec4>())
    range = {std::min<double>(range.x(), p.x), std::max<double>(range.y(), p.y)};
  if (range.x() > range.y()) return std::nullopt;
  return range;
}

}  // namespace fascia
