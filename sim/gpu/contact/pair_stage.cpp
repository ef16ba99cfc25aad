#include "sim/gpu/contact/pair_stage.h"

#include <algorithm>

#include "sim/model/unconstrained_parts.h"

namespace fascia {

using Eigen::Vector3d;
using shared::vec4;

PairStage::PairStage(const Model& model) : search_(model), gravity_(model.gravity) {
  if (empty()) return;
  const UnconstrainedParts free = unconstrained_parts(model, model.held());
  falls_.assign(free.unconstrained.begin(), free.unconstrained.end());
}

void PairStage::materials_changed(const Model& model) {
  search_.materials_changed(model);
  gravity_ = model.gravity;
}

void PairStage::begin(double duration, SimBuffers& buffers, std::uint32_t first_row) {
  start_ = buffers.download_vectors(buffers.displacement);
  const std::vector<Vector3d> velocity = buffers.download_vectors(buffers.velocity);
  end_ = start_;
  for (std::size_t v = 0; v < end_.size(); ++v)
    end_[v] += duration * velocity[v] + (falls_[v] ? duration * duration : 0) * gravity_;
  find(buffers, first_row);
}

bool PairStage::search_again(SimBuffers& buffers, std::uint32_t first_row) {
  if (empty() || !search_.sees_near()) return false;
  end_ = buffers.download_vectors(buffers.displacement);
  if (!search_.misses(end_)) return false;
  find(buffers, first_row);
  return true;
}

void PairStage::find(SimBuffers& buffers, std::uint32_t first_row) {
  const std::size_t offset = sizeof(vec4) * first_row, bytes = sizeof(vec4) * slot_count();
  std::vector<vec4> before(slot_count()), kept(slot_count());
  buffers.contact_memory.download(offset, bytes, before.data());
  std::vector<ContactForce> forces;
  for (const vec4& force : before) forces.push_back({{force.x, force.y, force.z}, force.w});
  rows_ = search_.find(start_, end_, forces);
  for (const PairRow& pair : rows_) kept[pair.slot] = before[pair.slot];
  buffers.contact_memory.upload(offset, bytes, kept.data());
  buffers.contact_before.upload(offset, bytes, kept.data());
}

void PairStage::limit(std::vector<float>& shares) const {
  constexpr double kLetIn = 0.05;  // of the skin: enough for what touches to press, and for its stiffness to be known
  const double let_in = kLetIn * search_.skin();
  for (const PairRow& pair : rows_) {
    double way = 0;
    for (std::size_t k = 0; k < 4; ++k)
      way += pair.weights[k] * pair.normal.dot(end_[pair.vertices[k]] - start_[pair.vertices[k]]);
    if (way >= 0 || pair.gap + way >= -let_in) continue;
    const auto share = static_cast<float>(std::max(0.0, pair.gap + let_in) / -way);
    for (const std::uint32_t body : pair.bodies) shares[body] = std::min(shares[body], share);
  }
}

}  // namespace fascia
