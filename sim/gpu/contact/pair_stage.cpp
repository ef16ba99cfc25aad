#include "sim/gpu/contact/pair_stage.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "sim/model/prescribed_motion.h"
#include "sim/model/unconstrained_parts.h"

namespace fascia {

using Eigen::Vector3d;
using shared::vec4;

PairStage::PairStage(const Model& model) : model_(model), search_(model) {
  if (empty()) return;
  const UnconstrainedParts free = unconstrained_parts(model, model.held());
  for (const std::uint32_t part : free.part) falls_.push_back(part != 0);
}

void PairStage::materials_changed(const Model& model, std::span<ContactForce> memory) {
  search_.materials_changed(model, memory);
}

void PairStage::begin(double time, const IntegratorStage& stage, SimBuffers& buffers, std::uint32_t first_row) {
  was_taken_back_ = std::exchange(is_taken_back_, false);
  const double duration = duration_ = stage.duration;
  start_time_ = time - duration;
  length_ = stage.length;
  start_ = buffers.download_vectors(buffers.displacement);
  const std::vector<Vector3d> velocity = buffers.download_vectors(buffers.velocity);
  end_ = start_;
  for (std::size_t v = 0; v < end_.size(); ++v)
    end_[v] += duration * velocity[v] + (falls_[v] ? duration * duration : 0) * model_.gravity;
  place_prescribed(model_, time, end_);
  find(buffers, first_row);
}

template <class F>
auto PairStage::timed(F&& search) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  auto result = search();
  search_ms_ += std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  return result;
}

bool PairStage::search_again(SimBuffers& buffers, std::uint32_t first_row) {
  if (empty() || !search_.sees_near()) return false;
  end_ = buffers.download_vectors(buffers.displacement);
  if (!timed([&] { return search_.misses(end_); })) return false;
  rows_ = timed([&] { return search_.find_again(); });
  upload_forces(buffers, first_row);
  return true;
}

void PairStage::take_back(SimBuffers& buffers) {
  if (empty() || !search_.sees_near()) return;
  end_ = buffers.download_vectors(buffers.displacement);
  const auto back = timed([&] { return search_.taken_back(start_, end_, consistent_masses(model_)); });
  if (!back) return;
  is_taken_back_ = true;
  if (was_taken_back_) {
    std::vector<Vector3d> velocity = buffers.download_vectors(buffers.velocity);
    PairSearch::slow_down(start_, end_, *back, duration_, velocity);
    buffers.upload_velocities(velocity);
  }
  buffers.upload_displacements(*back, buffers.displacement.read<shared::vec4>());
  ++taken_back_;
}

void PairStage::find(SimBuffers& buffers, std::uint32_t first_row) {
  before_.resize(row_count());
  buffers.contact_memory.download(sizeof(vec4) * first_row, sizeof(vec4) * row_count(), before_.data());
  std::vector<ContactForce> forces;
  for (const vec4& force : before_) forces.push_back({{force.x, force.y, force.z}, force.w});
  std::vector<Vector3d> path = end_;
  const std::vector<char> carried = search_.carried(forces, start_time_);
  for (std::size_t v = 0; v < path.size(); ++v)
    if (falls_[v] && carried[v]) path[v] -= duration_ * duration_ * model_.gravity;
  rows_ = timed([&] { return search_.find(start_, path, forces, length_, start_time_); });
  upload_forces(buffers, first_row);
}

void PairStage::upload_forces(SimBuffers& buffers, std::uint32_t first_row) const {
  const std::size_t offset = sizeof(vec4) * first_row, bytes = sizeof(vec4) * row_count();
  std::vector<vec4> kept(row_count());
  for (const PairRow& pair : rows_) {
    const std::uint32_t row = force_row(pair.slot);
    kept[row] = before_[row];
    kept[row].w = static_cast<float>(pair.before);
    vec4& met = kept[met_row(pair.slot)];
    *std::array{&met.x, &met.y, &met.z, &met.w}[pair.slot % 4] = static_cast<float>(pair.met);
  }
  buffers.contact_memory.upload(offset, bytes, kept.data());
  buffers.contact_before.upload(offset, bytes, kept.data());
}

void PairStage::limit(std::vector<float>& shares, std::vector<std::uint32_t>& leaders) const {
  std::iota(leaders.begin(), leaders.end(), 0u);
  const auto leader_of = [&](std::uint32_t body) {
    while (leaders[body] != body) body = leaders[body];
    return body;
  };
  for (const PairRow& pair : rows_) {
    double way = 0;
    for (std::size_t k = 0; k < 4; ++k)
      way += pair.weights[k] * pair.normal.dot(end_[pair.vertices[k]] - start_[pair.vertices[k]]);
    const bool meets = way < 0 && pair.gap + way < 0;
    if (!meets && pair.before <= 0) continue;
    const std::uint32_t a = leader_of(pair.bodies[0]), b = leader_of(pair.bodies[1]);
    leaders[std::max(a, b)] = std::min(a, b);
    if (!meets) continue;
    const auto share = static_cast<float>(std::max(0.0, pair.gap) / -way);
    shares[pair.bodies[0]] = std::min(shares[pair.bodies[0]], share);
  }
  for (std::uint32_t body = 0; body < leaders.size(); ++body) {
    leaders[body] = leader_of(body);
    shares[leaders[body]] = std::min(shares[leaders[body]], shares[body]);
  }
}

bool PairStage::parts() const {
  constexpr double kNearer = 1e-3;  // of the skin
  return std::any_of(rows_.begin(), rows_.end(), [least = -kNearer * search_.skin()](const PairRow& pair) {
    return pair.gap < least && pair.bodies[0] != pair.bodies[1];
  });
}

std::vector<PairStage::Support> PairStage::supports(std::size_t body_count) const {
  std::vector<Support> supports(body_count);
  for (const PairRow& pair : rows_) {
    if (pair.before <= 0 || pair.bodies[0] == pair.bodies[1]) continue;
    const vec4& across = before_[force_row(pair.slot)];
    const Vector3d force = pair.before * pair.normal + Vector3d(across.x, across.y, across.z);
    for (const std::size_t side : {0, 1}) {
      const double sign = side == 0 ? 1 : -1;
      Support& support = supports[pair.bodies[side]];
      support.force += sign * force;
      ++support.count;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t v = pair.vertices[k];
        const Vector3d fall = (falls_[v] ? duration_ * duration_ : 0) * model_.gravity;
        if (pair.sides[k] == side) support.way += sign * pair.weights[k] * (end_[v] - start_[v] - fall);
      }
    }
  }
  return supports;
}

}  // namespace fascia
