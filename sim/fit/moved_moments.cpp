#include "sim/fit/moved_moments.h"

#include "sim/reference/tangent/static_tangent.h"
#include "sim/reference/tangent/step_tangent.h"

namespace fascia {
namespace {

using reference::Nearby;
using Moment = Experiment::Moment;

void move(std::vector<Eigen::Vector3d>& displacement, const std::vector<Eigen::Vector3d>& rate, double step) {
  for (std::size_t v = 0; v < rate.size(); ++v) displacement[v] += step * rate[v];
}

class Mover {
 public:
  Mover(const Experiment::Response& response, const Model& here, const std::vector<ModelPair>& pairs, double step)
      : response_(response), here_(here), pairs_(pairs), step_(step) {
    moved_.assign(pairs.size(), {response.moments, response.moments});
    for (std::size_t p = 0; p < pairs.size(); ++p)
      for (std::size_t m = 0; m < response.moments.size(); ++m) {
        if (response.moments[m].springs.empty()) continue;
        moved_[p].below[m].springs = Experiment::springs_at(pairs[p].below, response.moments[m]);
        moved_[p].above[m].springs = Experiment::springs_at(pairs[p].above, response.moments[m]);
      }
  }

  bool follow_equilibria() {
    reference::StaticTangent tangent(here_);
    for (std::size_t m = 0; m < response_.moments.size(); ++m) {
      const Moment& moment = response_.moments[m];
      if (!tangent.linearize(moment.state, {here_, moment.springs})) return false;
      for (std::size_t p = 0; p < pairs_.size(); ++p)
        move_moment(m, p,
                    tangent.rate({pairs_[p].below, moved_[p].below[m].springs},
                                 {pairs_[p].above, moved_[p].above[m].springs}, step_));
    }
    return true;
  }

  bool follow_motion() {
    reference::StepTangent tangent(here_);
    std::vector<reference::StateRate> rates(pairs_.size(), tangent.at_rest());
    std::size_t m = 0;
    for (std::size_t i = 0; i <= response_.stages.size(); ++i) {
      for (; m < response_.moments.size() && response_.moments[m].stages == i; ++m)
        for (std::size_t p = 0; p < pairs_.size(); ++p) move_moment(m, p, reference::as_vectors(rates[p].displacement));
      if (i == response_.stages.size()) break;
      const Experiment::Stage& stage = response_.stages[i];
      const bool last = i + 1 == response_.stages.size();
      const State& after = last ? response_.moments.back().state : response_.stages[i + 1].before;
      const auto springs = [&](const Model& model) { return with_grabs({}, model.grabs, stage.step_end); };
      if (!tangent.linearize(stage.stage, stage.before, after.displacement, {here_, springs(here_)})) return false;
      for (std::size_t p = 0; p < pairs_.size(); ++p)
        rates[p] = tangent.rate(rates[p], {pairs_[p].below, springs(pairs_[p].below)},
                                {pairs_[p].above, springs(pairs_[p].above)}, step_);
    }
    return true;
  }

  std::vector<MomentPair> take() { return std::move(moved_); }

 private:
  void move_moment(std::size_t m, std::size_t p, const std::vector<Eigen::Vector3d>& rate) {
    move(moved_[p].below[m].state.displacement, rate, -step_);
    move(moved_[p].above[m].state.displacement, rate, step_);
  }

  const Experiment::Response& response_;
  const Model& here_;
  const std::vector<ModelPair>& pairs_;
  const double step_;
  std::vector<MomentPair> moved_;
};

}  // namespace

std::optional<std::vector<MomentPair>> moved_moments(const Experiment::Response& response, const Model& here,
                                                     const std::vector<ModelPair>& pairs, double step) {
  Mover mover(response, here, pairs, step);
  if (!(response.stages.empty() ? mover.follow_equilibria() : mover.follow_motion())) return std::nullopt;
  return mover.take();
}

}  // namespace fascia
