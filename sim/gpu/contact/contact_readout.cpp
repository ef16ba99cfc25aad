// What is read from contact on the GPU: its stiffness for the coarse level, forces of tools, pairs and vertices, and
// pressures for pictures.
#include <algorithm>
#include <span>

#include "sim/contact/tissue/tissue_surface.h"
#include "sim/gpu/contact/contact_term.h"

namespace fascia {

using Eigen::Vector3d;
using shared::vec4;

// The list stays as it is within a stage, and what it does not list has no stiffness.
void ContactTerm::read_stiffness(gl::Downloads& downloads) {
  std::size_t count = places_.size();
  if (read_list_.empty()) {
    read_list_.resize(4 + count);
    downloads.add(list_, read_list_.size() * sizeof(std::uint32_t), read_list_.data());
  } else if (const std::size_t listed = read_list_[3]; listed <= count) {
    const auto first = read_list_.begin() + 4, last = std::max_element(first, first + listed);
    count = listed > 0 ? std::min<std::size_t>(count, *last + std::size_t{1}) : 0;
  }
  read_blocks_.resize(2 * count);
  downloads.add(blocks_, read_blocks_.size() * sizeof(vec4), read_blocks_.data());
}

std::vector<PointStiffness> ContactTerm::stiffness_at_points() const {
  std::vector<PointStiffness> result;
  const std::size_t most = places_.size();
  const std::uint32_t count = read_list_[3];
  if (count > most) return result;  // a device that fails
  result.reserve(count);
  for (const std::uint32_t p : std::span(read_list_).subspan(4, count)) {
    if (p >= most) return {};  // a device that fails
    const vec4 &d = read_blocks_[2 * p], &s = read_blocks_[2 * p + 1];
    if (!(d.x + d.y + d.z > 0)) continue;
    Eigen::Matrix3d stiffness;
    stiffness << d.x, s.z, s.y, s.z, d.y, s.x, s.y, s.x, d.z;
    std::array<double, 4> weights{};
    if (p >= point_count())
      weights = pairs_.rows()[p - point_count()].weights;
    else
      std::copy_n(surface_.points[p].weights.begin(), 3, weights.begin());
    result.push_back({places_[p], weights, stiffness, p < point_count() ? p : PointStiffness::kUnnumbered});
  }
  return result;
}

std::vector<std::uint32_t> ContactTerm::near_vertices() const {
  std::vector<std::uint32_t> vertices;
  if (surface_.empty()) return vertices;
  const std::vector<std::uint32_t> near = near_.read<std::uint32_t>();
  for (std::uint32_t p = 0; p < point_count(); ++p)
    if (near[p] != 0) vertices.insert(vertices.end(), places_[p].begin(), places_[p].begin() + 3);
  return vertices;
}

ContactLoads ContactTerm::sum_of(const std::vector<vec4>& loads, const std::vector<PairRow>& pairs,
                                 const std::vector<vec4>& forces) const {
  ContactLoads result{std::vector<ToolLoad>(tools_.size()), {}};
  for (std::size_t p = 0; p < surface_.pieces.size(); ++p)
    for (std::size_t lane = 0; lane < kLoadLanes; ++lane) {
      const vec4* const sums = &loads[3 * (kLoadLanes * p + lane)];
      const vec4 &force = sums[0], &torque = sums[1];
      ToolLoad& load = result.tools[surface_.pieces[p].tool];
      load.force += Vector3d(force.x, force.y, force.z);
      load.torque += Vector3d(torque.x, torque.y, torque.z);
      load.normal += sums[2].x;
      result.on_held += Vector3d(sums[2].y, sums[2].z, sums[2].w);
      load.points += static_cast<std::uint32_t>(force.w);
      load.deepest = std::max<double>(load.deepest, torque.w);
    }
  const std::vector<char> held = pairs.empty() ? std::vector<char>() : model_.held();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const Vector3d force(forces[k].x, forces[k].y, forces[k].z);
    const double pressing = forces[k].w;
    for (std::size_t corner = 0; corner < 4; ++corner)
      if (held[pairs[k].vertices[corner]]) result.on_held += pairs[k].weights[corner] * force;
    if (pressing > 0 || !force.isZero(0))
      add_load(result.pairs, pairs[k], force, pressing, (pressing - pairs[k].before) / pairs[k].stiffness);
  }
  return result;
}

void ContactTerm::record_loads(gl::ProgramCache& programs) {
  if (!surface_.empty()) load_pass_ = load_pass(programs);
}

void ContactTerm::keep_loads() {
  std::vector<vec4> loads, forces(pairs_.rows().size());
  if (load_pass_) {
    load_pass_->run();
    loads = loads_.read<vec4>();
  }
  if (!forces.empty()) forces_.download(forces_of_pairs(), forces.size() * sizeof(vec4), forces.data());
  earlier_loads_.add(share_, sum_of(loads, pairs_.rows(), forces));
}

std::vector<Vector3d> ContactTerm::forces_at_vertices() const {
  std::vector<Vector3d> forces(model_.rest_positions.size(), Vector3d::Zero());
  if (!acts()) return forces;
  const std::vector<vec4> at_points = forces_.read<vec4>();
  const auto force_at = [&](std::size_t p) { return Vector3d(at_points[p].x, at_points[p].y, at_points[p].z); };
  for (std::size_t p = 0; p < surface_.points.size(); ++p)
    for (std::size_t k = 0; k < 3; ++k)
      forces[surface_.points[p].vertices[k]] += surface_.points[p].weights[k] * force_at(p);
  for (std::size_t p = 0; p < pairs_.rows().size(); ++p)
    for (std::size_t k = 0; k < 4; ++k)
      forces[pairs_.rows()[p].vertices[k]] += pairs_.rows()[p].weights[k] * force_at(point_count() + p);
  return forces;
}

void ContactTerm::forget_forces() {
  if (!acts()) return;
  pairs_.state_changed();
  earlier_loads_.begin();
  forces_.clear();
  rows_.clear();
}

void ContactTerm::let_go(SimBuffers& buffers) {
  forget_forces();
  buffers.contact_memory.clear();
  buffers.contact_before.clear();
}

void ContactTerm::bind_pressure(gl::ComputePass::Bindings& bindings) {
  if (!areas_) {
    std::vector<float> areas(model_.rest_positions.size());
    const std::vector<double> of_vertices = tissue_areas(model_, tissue_boundary(model_));
    for (std::size_t v = 0; v < areas.size(); ++v)
      areas[buffers_.placement.place[v]] = static_cast<float>(of_vertices[v]);
    areas_ = gl::Buffer("contact_area", areas);
  }
  bind_entries(bindings);
  bindings.insert(bindings.end(), {{"contact_force", &forces_}, {"contact_area", &areas_}});
}

}  // namespace fascia
