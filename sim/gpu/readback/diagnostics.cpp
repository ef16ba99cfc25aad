#include "sim/gpu/readback/diagnostics.h"

#include <algorithm>
#include <cmath>

#include "sim/gpu/passes/reduction.h"

namespace fascia {
namespace {

constexpr std::uint32_t kMostPartials = 4096;

}  // namespace

double Diagnostics::imbalance(const Eigen::Vector3d& weight, double of_support) const {
  double scale = std::max({of_support, reaction.norm(), tool_force.norm(), weight.norm(), inertia.norm()});
  for (const GrabForce& grab : grab_forces) scale = std::max(scale, grab.force.norm());
  for (const ToolLoad& load : tool_loads) scale = std::max(scale, load.force.norm());
  return scale > force_rounding ? (reaction + grab_force + tool_force + weight - inertia).norm() / scale : 0;
}

void Diagnostics::set_loads(ContactLoads of_step, const ContactLoads& at_end) {
  tool_loads = std::move(of_step.tools);
  pair_loads = std::move(of_step.pairs);
  tool_force.setZero();
  for (const ToolLoad& load : at_end.tools) tool_force += load.force;
}

DiagnosticsReader::DiagnosticsReader(const SimBuffers& buffers)
    : pair_partial_count_(lanes_read_back(buffers.pair_and_single_count(), kMostPartials)),
      quadratic_partial_count_(lanes_read_back(buffers.quadratic_count, kMostPartials)),
      vertex_partial_count_(lanes_read_back(buffers.vertex_count, kMostPartials)),
      leaves_out_(buffers.leaves_out),
      volume_(buffers.volume),
      mean_mass_(buffers.mean_mass),
      displacement_(buffers.displacement),
      tet_partials_("tet_partials", (pair_partial_count_ + quadratic_partial_count_) * sizeof(shared::TetPartial)),
      vertex_partials_("vertex_partials", vertex_partial_count_ * sizeof(shared::VertexPartial)) {
  if (quadratic_partial_count_ > 0)
    centroid_partials_ = gl::Buffer("centroid_partials", quadratic_partial_count_ * sizeof(shared::CentroidPartial));
}

void DiagnosticsReader::record(gl::ProgramCache& programs, const SimBuffers& buffers, const Features& features,
                               const gl::Buffer& previous_strain, const EnergyTerms& terms) {
  passes_.clear();
  gl::ComputePass::Bindings tet{
      {"step", &buffers.step}, {"displacement", &buffers.displacement}, {"tet_partials", &tet_partials_}};
  tet = with_damping(with_material(std::move(tet), features, buffers), features, previous_strain);
  if (buffers.pair_and_single_count() > 0) {
    gl::ComputePass::Constants constants = constants_of_pairs(buffers);
    constants.emplace_back("pair_and_single_count", buffers.pair_and_single_count());
    passes_.emplace_back(programs.compute("sim/readback/diagnose_tet.comp", defines_of(features)),
                         with_slots(tet, buffers), pair_partial_count_, std::move(constants));
  }
  if (buffers.has_quadratic()) {
    gl::ComputePass::Constants constants = constants_of_quadratic(buffers);
    constants.insert(constants.end(),
                     {{"quadratic_count", buffers.quadratic_count}, {"first_partial", pair_partial_count_}});
    passes_.emplace_back(
        programs.compute("sim/quadratic/quadratic_diagnose.comp", defines_of_quadratic(defines_of(features), buffers)),
        with_quadratic_slots(tet, buffers), quadratic_partial_count_, std::move(constants));
    constants = constants_of_quadratic(buffers);
    constants.emplace_back("quadratic_count", buffers.quadratic_count);
    passes_.emplace_back(programs.compute("sim/quadratic/centroid_diagnose.comp", defines_of_quadratic({}, buffers)),
                         with_quadratic_slots({{"step", &buffers.step},
                                               {"rest_position", &buffers.rest_position},
                                               {"displacement", &buffers.displacement},
                                               {"velocity", &buffers.velocity},
                                               {"predicted", &buffers.predicted},
                                               {"predicted_centroid", &buffers.predicted_centroid},
                                               {"centroid_partials", &centroid_partials_}},
                                              buffers),
                         quadratic_partial_count_, std::move(constants));
    passes_.back().follow("has_step", has_step_);
  }
  for (const EnergyTerm* term : terms)
    if (term->acts())
      for (gl::ComputePass& pass : term->impulses(programs, buffers)) passes_.push_back(std::move(pass));
  gl::ComputePass::Bindings vertex{{"step", &buffers.step},
                                   {"rest_position", &buffers.rest_position},
                                   {"mass", &buffers.mass},
                                   {"displacement", &buffers.displacement},
                                   {"predicted", &buffers.predicted},
                                   {"velocity", &buffers.velocity},
                                   {"slot_begin", &buffers.slot_begin},
                                   {"correction", &buffers.correction},
                                   {"vertex_partials", &vertex_partials_}};
  gl::Defines vertex_defines;
  if (buffers.has_quadratic()) {
    vertex.emplace_back("own_mass", &buffers.own_mass);
    vertex_defines.emplace_back("QUADRATIC_TETS", "1");
  }
  passes_.emplace_back(programs.compute("sim/readback/diagnose_vertex.comp", vertex_defines), std::move(vertex),
                       vertex_partial_count_, gl::ComputePass::Constants{{"vertex_count", buffers.vertex_count}});
}

void DiagnosticsReader::request(const GrabSprings& grab, const ContactTerm& contact, double substep, double time,
                                const gl::Buffer* stop_state, bool has_step) {
  has_step_ = has_step;
  for (const gl::ComputePass& pass : passes_) pass.run();

  newest_ ^= 1u;
  Pending& p = pending_[newest_];
  const std::size_t grab_bytes = grab.count() * sizeof(shared::vec4);
  const std::size_t probe_bytes = probe_ ? sizeof(shared::vec4) : 0;
  const std::size_t bytes = tet_partials_.bytes() + vertex_partials_.bytes() + centroid_partials_.bytes() + grab_bytes +
                            probe_bytes + (stop_state ? stop_state->bytes() : 0) + contact.loads().bytes() +
                            contact.pairs().size() * sizeof(shared::vec4);
  if (p.staging.bytes() != bytes) p.staging = gl::Buffer::staging("diagnostics_staging", bytes);
  std::size_t offset = 0;
  const auto copy_part = [&](const gl::Buffer& from, std::size_t begin, std::size_t size) {
    p.staging.copy(from, begin, size, offset);
    offset += size;
  };
  const auto copy = [&](const gl::Buffer& from) { copy_part(from, 0, from.bytes()); };
  copy(tet_partials_);
  copy(vertex_partials_);
  if (centroid_partials_) copy(centroid_partials_);
  if (grab_bytes) copy(grab.multiplier());
  if (probe_) copy_part(displacement_, *probe_ * probe_bytes, probe_bytes);
  if (stop_state) copy(*stop_state);
  if (contact.loads()) copy(contact.loads());
  p.pairs = contact.pairs();
  p.earlier = contact.earlier_loads();
  if (!p.pairs.empty()) copy_part(contact.forces(), contact.forces_of_pairs(), p.pairs.size() * sizeof(shared::vec4));
  p.owners = grab.owners();
  p.has_probe = probe_.has_value();
  p.substep = substep;
  p.time = time;
  p.mean_mass = mean_mass_;
  p.counts_iterations = stop_state != nullptr;
  p.contact = contact.acts() ? &contact : nullptr;
  p.fence.set();
}

std::optional<Diagnostics> DiagnosticsReader::take(bool wait) {
  Pending& newest = pending_[newest_];
  Pending& older = pending_[newest_ ^ 1u];
  for (Pending* p : {&newest, &older}) {
    if (!p->fence.take(wait)) continue;
    if (p == &newest) older.fence.clear();  // superseded
    return sum_up(*p);
  }
  return std::nullopt;
}

Diagnostics DiagnosticsReader::sum_up(const Pending& pending) const {
  std::vector<shared::TetPartial> tets(pair_partial_count_ + quadratic_partial_count_);
  std::vector<shared::VertexPartial> vertices(vertex_partial_count_);
  std::vector<shared::vec4> grabbed(pending.owners.joined.size());
  pending.staging.download(0, tet_partials_.bytes(), tets.data());
  pending.staging.download(tet_partials_.bytes(), vertex_partials_.bytes(), vertices.data());
  const std::size_t vertex_end = tet_partials_.bytes() + vertex_partials_.bytes();
  std::vector<shared::CentroidPartial> centroids(quadratic_partial_count_);
  if (centroid_partials_) pending.staging.download(vertex_end, centroid_partials_.bytes(), centroids.data());
  const std::size_t grab_begin = vertex_end + centroid_partials_.bytes(),
                    grab_bytes = grabbed.size() * sizeof(shared::vec4);
  if (!grabbed.empty()) pending.staging.download(grab_begin, grab_bytes, grabbed.data());
  std::size_t next = grab_begin + grab_bytes;
  Diagnostics d;
  d.time = pending.time;
  if (pending.has_probe) {
    shared::vec4 u{};
    pending.staging.download(next, sizeof u, &u);
    d.probe = Eigen::Vector3d(u.x, u.y, u.z);
    next += sizeof u;
  }
  if (pending.counts_iterations) {
    std::uint32_t iterations = 0;
    pending.staging.download(next, sizeof iterations, &iterations);
    d.iterations = static_cast<int>(iterations);
  }
  if (pending.contact) {
    std::vector<shared::vec4> loads(pending.contact->loads().bytes() / sizeof(shared::vec4)),
        pairs(pending.pairs.size());
    const std::size_t behind = pairs.size() * sizeof(shared::vec4), bytes = loads.size() * sizeof(shared::vec4);
    pending.staging.download(pending.staging.bytes() - behind - bytes, bytes, loads.data());
    pending.staging.download(pending.staging.bytes() - behind, behind, pairs.data());
    const ContactLoads at_end = pending.contact->sum_of(loads, pending.pairs, pairs);
    d.set_loads(pending.earlier.mean(at_end), at_end);
    d.reaction -= at_end.on_held;
  }
  double inverted = 0, growth = 0, residual = 0, inertia = 0, load = 0, motion = 0, grab = 0, speed2 = 0, strain2 = 0;
  d.min_det_f = leaves_out_ ? 1 : 3.4e38;
  d.max_det_f = leaves_out_ ? 1 : -3.4e38;
  for (const shared::TetPartial& t : tets) {
    d.min_det_f = std::min<double>(d.min_det_f, t.range.x);
    d.max_det_f = std::max<double>(d.max_det_f, t.range.y);
    d.max_strain = std::max<double>(d.max_strain, t.range.z);
    d.max_von_mises = std::max<double>(d.max_von_mises, t.range.w);
    d.elastic += t.sums.x;
    inverted += t.sums.y;
    growth += t.sums.z;
    strain2 += t.sums.w;
  }
  for (const shared::CentroidPartial& c : centroids) {
    d.angular_momentum += Eigen::Vector3d(c.angular.x, c.angular.y, c.angular.z);
    d.kinetic += c.angular.w;
    d.inertia += Eigen::Vector3d(c.inertia.x, c.inertia.y, c.inertia.z);
  }
  for (const shared::VertexPartial& v : vertices) {
    d.momentum += Eigen::Vector3d(v.momentum.x, v.momentum.y, v.momentum.z);
    d.kinetic += v.momentum.w;
    d.angular_momentum += Eigen::Vector3d(v.angular.x, v.angular.y, v.angular.z);
    d.gravitational += v.angular.w;
    d.reaction += Eigen::Vector3d(v.reaction.x, v.reaction.y, v.reaction.z);
    speed2 = std::max<double>(speed2, v.reaction.w);
    residual += v.residual.x;
    inertia += v.residual.y;
    load += v.residual.z;
    motion += v.residual.w;
    d.inertia += Eigen::Vector3d(v.inertia.x, v.inertia.y, v.inertia.z);
    d.force_rounding += 1e-6 * v.inertia.w;  // ten float32 roundings
  }
  std::vector<Eigen::Vector3d> spring_forces;
  for (const shared::vec4& g : grabbed) {
    const Eigen::Vector3d impulse(g.x, g.y, g.z);
    spring_forces.push_back(impulse / (pending.substep * pending.substep));
    d.grab_force += spring_forces.back();
    grab += (impulse / pending.mean_mass).squaredNorm();
  }
  d.grab_forces = forces_of_grabs(pending.owners.springs, pending.owners.joined, pending.owners.place, spring_forces);
  const double scale = std::sqrt(inertia) + std::sqrt(load) + std::sqrt(grab);
  const double rounding = 1e-6 * pending.substep * std::sqrt(motion);  // ten float32 roundings of M (u - u_n)
  d.residual = scale > rounding ? std::sqrt(residual) / scale : 0;
  d.rms_strain = std::sqrt(strain2 / volume_);
  d.inverted = static_cast<int>(inverted);
  d.max_speed = std::sqrt(speed2);
  d.volume_ratio = 1 + growth / volume_;
  // A value that is not finite in one tet or at one vertex makes the sums not finite.
  d.finite = std::isfinite(d.elastic) && std::isfinite(growth) && std::isfinite(d.gravitational) &&
             d.angular_momentum.allFinite();
  return d;
}

}  // namespace fascia
