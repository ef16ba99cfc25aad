#include "sim/gpu/resting_regions.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/gpu/passes/force_clusters.h"
#include "sim/model/rest_detector.h"

namespace fascia {
namespace {

constexpr std::uint32_t kRegionVertices = 64;  // about four tets in each direction
constexpr double kMostShare = 0.75;            // of the work: above it lists cost more than they save

// For every vertex, the smallest vertex that tets connect with it.
std::vector<std::uint32_t> component_of(const SimBuffers& buffers) {
  std::vector<std::uint32_t> parent(buffers.vertex_count);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (std::uint32_t t = 0; t < buffers.tet_count; ++t)
    for (const std::uint32_t v : buffers.element(t)) {
      const std::uint32_t x = root(buffers.tets[t][0]), y = root(v);
      parent[std::max(x, y)] = std::min(x, y);
    }
  for (std::uint32_t v = 0; v < buffers.vertex_count; ++v) parent[v] = root(v);
  return parent;
}

}  // namespace

RestingRegions::RestingRegions(gl::ProgramCache& programs, const SimBuffers& buffers)
    : buffers_(buffers), vertex_region_(buffers.vertex_count) {
  // Divides the vertices, in the order of the curve and body by body, into pieces.
  const std::vector<std::uint32_t> component = component_of(buffers);
  std::vector<char> met(buffers.vertex_count, 0);
  for (std::uint32_t t = 0; t < buffers.tet_count; ++t)
    for (const std::uint32_t v : buffers.element(t)) {
      if (met[v]) continue;
      met[v] = 1;
      region_vertices_.push_back(v);
    }
  std::stable_sort(region_vertices_.begin(), region_vertices_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return component[a] < component[b]; });
  for (std::size_t k = 0; k < region_vertices_.size(); ++k) {
    const bool another = k == 0 || component[region_vertices_[k]] != component[region_vertices_[k - 1]];
    if (another || k - region_begin_.back() == kRegionVertices) region_begin_.push_back(static_cast<std::uint32_t>(k));
    vertex_region_[region_vertices_[k]] = static_cast<std::uint32_t>(region_begin_.size() - 1);
  }
  region_begin_.push_back(static_cast<std::uint32_t>(region_vertices_.size()));

  pressed_.resize(region_count());
  neighbors_.resize(region_count());
  for (std::uint32_t t = 0; t < buffers.tet_count; ++t)
    for (const std::uint32_t v : buffers.element(t))
      for (const std::uint32_t w : buffers.element(t)) neighbors_[vertex_region_[v]].push_back(vertex_region_[w]);
  for (std::vector<std::uint32_t>& list : neighbors_) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  active_.vertices = gl::Buffer("active_vertices", sizeof(std::uint32_t) * buffers.vertex_count);
  if (buffers.has_linear())
    active_.pairs = gl::Buffer("active_pairs", sizeof(std::uint32_t) * buffers.pair_and_single_count());
  if (ForceClusters::serve(programs, buffers))
    active_.clusters = gl::Buffer("active_clusters",
                                  3 * sizeof(std::uint32_t) * ForceClusters::count_of(buffers.pair_and_single_count()));
  if (buffers.has_quadratic())
    active_.quadratic = gl::Buffer("active_quadratic", sizeof(std::uint32_t) * buffers.quadratic_count);
  begin_ = gl::Buffer("region_begin", region_begin_);
  vertices_ = gl::Buffer("region_vertices", region_vertices_);
  motion_ = gl::Buffer("region_motion", 2 * sizeof(float) * region_count());
  measured_ = gl::Buffer::staging("region_measured", motion_.bytes());
  for (const std::uint32_t accumulate : {0u, 1u})
    measure_.emplace_back(programs.compute("sim/readback/region_motion.comp"),
                          gl::ComputePass::Bindings{{"displacement", &buffers.displacement},
                                                    {"velocity", &buffers.velocity},
                                                    {"region_begin", &begin_},
                                                    {"region_vertices", &vertices_},
                                                    {"region_motion", &motion_}},
                          region_count(), gl::ComputePass::Constants{{"accumulate", accumulate}});
}

bool RestingRegions::begin_step(const SolverSettings& settings,
                                const std::function<std::vector<std::uint32_t>()>& awake) {
  if (phase_ == kWholeSteps) partial_ = list(settings, awake());
  if (phase_ < kWholeSteps) partial_ = false;
  return partial_;
}

void RestingRegions::press(std::uint32_t vertex) {
  char& pressed = pressed_[vertex_region_[vertex]];
  met_ |= partial_ && !pressed;
  pressed = 1;
}

void RestingRegions::end_step() {
  if (phase_ < kWholeSteps) measure_[static_cast<std::size_t>(phase_)].run();
  if (phase_ == kWholeSteps - 1) measured_.copy(motion_, motion_.bytes());
  phase_ = (phase_ + 1) % kRound;
  if (met_ || phase_ == 0) restart();
  met_ = false;
}

bool RestingRegions::list(const SolverSettings& settings, const std::vector<std::uint32_t>& awake) {
  const auto motion = measured_.read<float>();
  const double h = settings.substep();
  std::vector<char> woken(region_count()), moving(region_count());
  for (std::uint32_t r = 0; r < region_count(); ++r) {
    const double speed = std::sqrt(static_cast<double>(motion[2 * r])),
                 displacement = std::sqrt(static_cast<double>(motion[2 * r + 1]));
    woken[r] = !is_still(speed * h, h, displacement, settings, buffers_.size);
  }
  for (const std::uint32_t v : awake) woken[vertex_region_[v]] = 1;
  for (std::uint32_t r = 0; r < region_count(); ++r)
    for (const std::uint32_t n : neighbors_[r]) moving[r] |= woken[n];
  if (moving == listed_) return active_.work <= kMostShare * buffers_.work();
  listed_ = moving;

  std::vector<std::uint32_t> pairs, quadratic, tets, vertices;
  const auto moves = [&](std::uint32_t t) {
    const ElementVertices element = buffers_.element(t);
    return std::any_of(element.begin(), element.end(), [&](std::uint32_t v) { return moving[vertex_region_[v]] != 0; });
  };
  for (std::uint32_t i = 0; i < buffers_.pair_and_single_count(); ++i) {
    const bool two = i < buffers_.pair_count;
    const std::uint32_t second = buffers_.pair_and_single_count() + i;
    if (!moves(i) && !(two && moves(second))) continue;
    pairs.push_back(i);
    tets.push_back(i);
    if (two) tets.push_back(second);
  }
  const auto linear = static_cast<std::uint32_t>(tets.size());
  for (std::uint32_t e = 0; e < buffers_.quadratic_count; ++e) {
    if (!moves(buffers_.linear_count() + e)) continue;
    quadratic.push_back(e);
    tets.push_back(buffers_.linear_count() + e);
  }
  active_.pair_count = static_cast<std::uint32_t>(pairs.size());
  active_.quadratic_count = static_cast<std::uint32_t>(quadratic.size());
  active_.work = SimBuffers::work_of(linear, active_.quadratic_count);
  if (active_.work > kMostShare * buffers_.work()) return false;
  std::vector<char> beside(buffers_.vertex_count, 0);
  for (const std::uint32_t t : tets)
    for (const std::uint32_t v : buffers_.element(t)) beside[v] = !moving[vertex_region_[v]];
  for (std::uint32_t r = 0; r < region_count(); ++r)
    if (moving[r])
      vertices.insert(vertices.end(), region_vertices_.begin() + region_begin_[r],
                      region_vertices_.begin() + region_begin_[r + 1]);
  active_.moving_count = static_cast<std::uint32_t>(vertices.size());
  for (const std::uint32_t v : region_vertices_)
    if (beside[v]) vertices.push_back(v);
  active_.vertex_count = static_cast<std::uint32_t>(vertices.size());
  if (!pairs.empty()) active_.pairs.upload(0, pairs.size() * sizeof(std::uint32_t), pairs.data());
  if (active_.clusters && !pairs.empty()) {
    const std::vector<std::uint32_t> clusters = clusters_of(pairs);
    active_.cluster_invocations = static_cast<std::uint32_t>(clusters.size()) / 3 * ForceClusters::kPairs;
    active_.clusters.upload(0, clusters.size() * sizeof(std::uint32_t), clusters.data());
  }
  if (!quadratic.empty()) active_.quadratic.upload(0, quadratic.size() * sizeof(std::uint32_t), quadratic.data());
  active_.vertices.upload(0, vertices.size() * sizeof(std::uint32_t), vertices.data());
  return true;
}

}  // namespace fascia
