#include "app/headless/interpolated_frames.h"

#include <algorithm>
#include <cmath>

namespace fascia {
namespace {

using shared::vec4;

// Steps: one before the interval, its two ends, those ahead, and one that is being replaced
constexpr std::size_t kKept = 6;

}  // namespace

InterpolatedFrames::InterpolatedFrames(const std::optional<Replay>& replay) {
  if (!replay) return;
  for (const Input& input : replay->inputs)
    if (std::holds_alternative<ResetInput>(input.change) || std::holds_alternative<RestoreInput>(input.change))
      jumps_.insert(input.step == replay->steps ? input.step - 1
                                                : input.step);  // the final input acts after the last step
}

void InterpolatedFrames::add(long step, Simulation& simulation) {
  if (known_.empty()) first_ = step;
  simulation.gpu()->publish();
  known_.push_back(simulation.gpu()->positions().read<vec4>());
  if (known_.size() <= kKept) return;
  known_.pop_front();
  ++first_;
}

const std::vector<vec4>& InterpolatedFrames::positions(long step) const {
  return known_[static_cast<std::size_t>(step - first_)];
}

bool InterpolatedFrames::joined(long from, long to) const {
  return from >= first_ && to < first_ + static_cast<long>(known_.size()) && !jumps_.count(from);
}

const gl::Buffer& InterpolatedFrames::at(double step) {
  const long before =
      std::clamp(static_cast<long>(std::floor(step)), first_, first_ + static_cast<long>(known_.size()) - 1);
  const double t = step - static_cast<double>(before);
  std::vector<vec4> result = positions(before);
  if (t > 0 && joined(before, before + 1)) {
    const std::vector<vec4>& a = positions(before);
    const std::vector<vec4>& b = positions(before + 1);
    const std::vector<vec4>* earlier = joined(before - 1, before) ? &positions(before - 1) : nullptr;
    const std::vector<vec4>* later = joined(before + 1, before + 2) ? &positions(before + 2) : nullptr;
    const double t2 = t * t, t3 = t2 * t;
    const double wa = 2 * t3 - 3 * t2 + 1, ma = t3 - 2 * t2 + t, wb = 3 * t2 - 2 * t3, mb = t3 - t2;
    const auto between = [&](std::size_t v, float vec4::*k) {
      const double xa = a[v].*k, xb = b[v].*k;
      const double slope_a = earlier ? 0.5 * (xb - (*earlier)[v].*k) : xb - xa,
                   slope_b = later ? 0.5 * ((*later)[v].*k - xa) : xb - xa;
      return static_cast<float>(wa * xa + ma * slope_a + wb * xb + mb * slope_b);
    };
    for (std::size_t v = 0; v < result.size(); ++v) {
      result[v] = {between(v, &vec4::x), between(v, &vec4::y), between(v, &vec4::z),
                   static_cast<float>((1 - t) * a[v].w + t * b[v].w)};
    }
  }
  const std::size_t bytes = result.size() * sizeof(vec4);
  if (!between_) between_ = gl::Buffer("positions_between_steps", bytes);
  between_.upload(0, bytes, result.data());
  return between_;
}

}  // namespace fascia
