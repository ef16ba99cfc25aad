#include "sim/fit/simulated/moved_moments.h"

#include <algorithm>
#include <memory>
#include <thread>

#include "sim/fit/simulated/in_parallel.h"
#include "sim/reference/tangent/static_tangent.h"
#include "sim/reference/tangent/step_tangent.h"

namespace fascia {
namespace {

using reference::Nearby;

void move(std::vector<Eigen::Vector3d>& displacement, const std::vector<Eigen::Vector3d>& rate, double step) {
  for (std::size_t v = 0; v < rate.size(); ++v) displacement[v] += step * rate[v];
}

class Mover {
 public:
  Mover(const Course& course, const Model& here, const std::vector<ModelPair>& pairs, double step)
      : course_(course), here_(here), pairs_(pairs), step_(step) {
    moved_.assign(pairs.size(), {course.moments, course.moments});
    for (std::size_t p = 0; p < pairs.size(); ++p)
      for (std::size_t m = 0; m < course.moments.size(); ++m) {
        if (course.moments[m].springs.empty()) continue;
        moved_[p].below[m].springs = springs_at(pairs[p].below, course.moments[m]);
        moved_[p].above[m].springs = springs_at(pairs[p].above, course.moments[m]);
      }
  }

  bool follow_equilibria() {
    reference::StaticTangent tangent(here_);
    for (std::size_t m = 0; m < course_.moments.size(); ++m) {
      const Moment& moment = course_.moments[m];
      if (!tangent.linearize(moment.state, {here_, moment.springs})) return false;
      for (std::size_t p = 0; p < pairs_.size(); ++p)
        move_moment(m, p,
                    tangent.rate({pairs_[p].below, moved_[p].below[m].springs},
                                 {pairs_[p].above, moved_[p].above[m].springs}, step_));
    }
    return true;
  }

  // The factors of a few stages at once, on as many cores; then the rates, of which each needs the one before.
  bool follow_motion() {
    constexpr std::size_t kMost = 4;  // factors in memory
    const std::size_t stages = course_.stages.size();
    std::vector<std::unique_ptr<reference::StepTangent>> tangents(
        std::clamp<std::size_t>(std::min<std::size_t>(std::thread::hardware_concurrency(), stages), 1, kMost));
    in_parallel(tangents.size(), [&](std::size_t k) { tangents[k] = std::make_unique<reference::StepTangent>(here_); });
    std::vector<reference::StateRate> rates(pairs_.size(), tangents[0]->at_rest());
    move_moments_after(0, rates);
    for (std::size_t first = 0; first < stages; first += tangents.size()) {
      const std::size_t count = std::min(tangents.size(), stages - first);
      std::vector<char> stable(count);
      in_parallel(count, [&](std::size_t k) { stable[k] = linearize(first + k, *tangents[k]); });
      if (std::find(stable.begin(), stable.end(), false) != stable.end()) return false;
      for (std::size_t k = 0; k < count; ++k) {
        const double end = course_.stages[first + k].step_end;
        for (std::size_t p = 0; p < pairs_.size(); ++p) {
          const ModelPair& pair = pairs_[p];
          rates[p] = tangents[k]->rate(rates[p], {pair.below, springs(pair.below, end)},
                                       {pair.above, springs(pair.above, end)}, step_);
        }
        move_moments_after(first + k + 1, rates);
      }
    }
    return true;
  }

  std::vector<MomentPair> take() { return std::move(moved_); }

 private:
  static std::vector<GrabSpring> springs(const Model& model, double time) { return with_grabs({}, model.grabs, time); }

  bool linearize(std::size_t i, reference::StepTangent& tangent) const {
    const SimulatedStage& stage = course_.stages[i];
    const bool last = i + 1 == course_.stages.size();
    const State& after = last ? course_.moments.back().state : course_.stages[i + 1].before;
    return tangent.linearize(stage.stage, stage.before, after.displacement, {here_, springs(here_, stage.step_end)});
  }

  void move_moments_after(std::size_t stages, const std::vector<reference::StateRate>& rates) {
    for (std::size_t m = 0; m < course_.moments.size(); ++m)
      for (std::size_t p = 0; p < pairs_.size() && course_.moments[m].stages == stages; ++p)
        move_moment(m, p, reference::as_vectors(rates[p].displacement), rates[p].acceleration);
  }

  void move_moment(std::size_t m, std::size_t p, const std::vector<Eigen::Vector3d>& rate,
                   const Eigen::VectorXd& acceleration = {}) {
    State &below = moved_[p].below[m].state, &above = moved_[p].above[m].state;
    move(below.displacement, rate, -step_);
    move(above.displacement, rate, step_);
    if (below.acceleration.empty()) return;
    const std::vector<Eigen::Vector3d> of_acceleration = reference::as_vectors(acceleration);
    move(below.acceleration, of_acceleration, -step_);
    move(above.acceleration, of_acceleration, step_);
  }

  const Course& course_;
  const Model& here_;
  const std::vector<ModelPair>& pairs_;
  const double step_;
  std::vector<MomentPair> moved_;
};

}  // namespace

std::optional<std::vector<MomentPair>> moved_moments(const Course& course, const Model& here,
                                                     const std::vector<ModelPair>& pairs, double step) {
  Mover mover(course, here, pairs, step);
  if (!(course.stages.empty() ? mover.follow_equilibria() : mover.follow_motion())) return std::nullopt;
  return mover.take();
}

}  // namespace fascia
