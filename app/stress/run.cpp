#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/stress/stress.h"
#include "sim/contact/tissue/penetration.h"
#include "sim/simulation/simulation.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kRecovered = 1e-3;                  // RMS displacement, in sizes
constexpr double kGrowth = 0.02;                     // of energy and momenta, relative to their initial scale
constexpr double kCreep = 1e-6;                      // StressCriteria::lies_still, in sizes
constexpr double kSprungBack = 1e-4, kStill = 1e-3;  // StressCriteria::springs_back, carries_its_weight

// Reference values for the state: its initial measures, and the sizes that make them relative.
class Ledger {
 public:
  explicit Ledger(const Simulation& simulation) : model_(simulation.model), masses_(consistent_masses(model_)) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& x : model_.rest_positions) box.extend(x);
    size_ = box.diagonal().norm();
    const State start = simulation.state();
    first_ = reference::measure(model_, start);
    first_energy_ = energy(first_, start);
    double mass = 0, moment = 0;
    for (std::size_t v = 0; v < masses_.size(); ++v) {
      mass += masses_[v];
      moment += masses_[v] * (model_.rest_positions[v] + start.displacement[v]).norm();
    }
    // The waves of the initial strain carry momenta of this size, although they cancel.
    const double speed = std::sqrt(2 * (first_.kinetic + first_.elastic) / mass);
    momentum_scale_ = mass * speed;
    angular_scale_ = moment * speed;
    energy_scale_ = first_.kinetic + first_.elastic + mass * model_.gravity.norm() * size_;
  }

  double size() const { return size_; }
  double rms(const State& state) const {
    double sum = 0;
    for (const Vector3d& u : state.displacement) sum += u.squaredNorm();
    return std::sqrt(sum / static_cast<double>(state.displacement.size())) / size_;
  }
  double farthest(const State& state) const {
    double longest = 0;
    for (const Vector3d& u : state.displacement) longest = std::max(longest, u.norm());
    return longest / size_;
  }
  double farthest_between(const State& a, const State& b) const {
    double longest = 0;
    for (std::size_t v = 0; v < a.displacement.size(); ++v)
      longest = std::max(longest, (a.displacement[v] - b.displacement[v]).norm());
    return longest / size_;
  }
  double energy_growth(const reference::Measures& now, const State& state) const {
    return (energy(now, state) - first_energy_) / energy_scale_;
  }
  double momentum_growth(const reference::Measures& now) const {
    return std::max((now.momentum - first_.momentum).norm() / momentum_scale_,
                    (now.angular_momentum.norm() - first_.angular_momentum.norm()) / angular_scale_);
  }

 private:
  double energy(const reference::Measures& measures, const State& state) const {
    double potential = 0;
    for (std::size_t v = 0; v < masses_.size(); ++v)
      potential -= masses_[v] * model_.gravity.dot(state.displacement[v]);
    return measures.kinetic + measures.elastic + potential;
  }

  const Model& model_;
  std::vector<double> masses_;
  double size_ = 0, first_energy_ = 0, energy_scale_ = 0, momentum_scale_ = 0, angular_scale_ = 0;
  reference::Measures first_;
};

}  // namespace

StressResult run_stress_case(Simulation& simulation, const StressCriteria& criteria) {
  StressResult result;
  const auto fail = [&](const auto&... parts) {
    std::ostringstream text;
    text.precision(3);
    (text << ... << parts);
    result.failures.push_back(text.str());
  };
  const Ledger ledger(simulation);
  const bool every_step = criteria.creates_no_energy || criteria.creates_no_momentum || criteria.springs_back;
  double most_elastic = 0;
  reference::Measures now;
  State middle;
  const long steps = simulation.replay()->steps;
  while (result.steps < steps) {
    simulation.step();
    ++result.steps;
    const bool diverged = simulation.check_now().has_value();
    const State state = simulation.state();
    if (!is_finite(state)) {
      fail("not finite after ", result.steps, " steps");
      return result;
    }
    if (diverged) {
      fail("ran away after ", result.steps, " steps");
      return result;
    }
    if (result.steps <= steps / 2) middle = state;
    result.rms = ledger.rms(state);
    result.farthest = std::max(result.farthest, ledger.farthest(state));
    if (result.rms >= kRecovered)
      result.recovered_after = -1;
    else if (result.recovered_after < 0)
      result.recovered_after = simulation.time();
    const bool last = result.steps == steps;
    if (!every_step && !last) continue;
    now = reference::measure(simulation.model, state);
    most_elastic = std::max(most_elastic, now.elastic);
    result.energy_growth = std::max(result.energy_growth, ledger.energy_growth(now, state));
    result.momentum_growth = std::max(result.momentum_growth, ledger.momentum_growth(now));
  }
  result.inverted = now.inverted;
  result.least_volume_ratio = now.min_det_f;
  result.elastic = now.elastic;
  if (result.farthest > criteria.farthest) fail("moved by ", result.farthest, " sizes");
  if (criteria.keeps_upright && result.inverted > 0) fail(result.inverted, " tets inside out at the end");
  if (criteria.recovers && result.rms >= kRecovered) fail("off its rest shape by ", result.rms, " sizes RMS");
  if (const double way = ledger.farthest_between(middle, simulation.state()); criteria.lies_still && way > kCreep)
    fail("moved by ", way, " sizes where it lies");
  if (criteria.stays_apart)
    if (const std::size_t cuts = penetrating_triangles(simulation.model, simulation.state().displacement); cuts > 0)
      fail(cuts, " triangles cut each other at the end");
  if (criteria.springs_back && now.kinetic + now.elastic > kSprungBack * most_elastic)
    fail("keeps ", now.kinetic + now.elastic, " J of ", most_elastic, " J");
  if (criteria.carries_its_weight) {
    const double work = -now.gravitational;
    if (now.elastic > work) fail("elastic energy of ", now.elastic, " J, work of gravity ", work, " J");
    if (now.kinetic > kStill * work) fail("moves with ", now.kinetic, " J, work of gravity ", work, " J");
  }
  if (criteria.creates_no_energy && result.energy_growth > kGrowth)
    fail("energy grew by ", 100 * result.energy_growth, " %");
  if (criteria.creates_no_momentum && result.momentum_growth > kGrowth)
    fail("momentum grew by ", 100 * result.momentum_growth, " %");
  return result;
}

}  // namespace fascia
