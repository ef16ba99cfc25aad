#include "sim/gpu/contact/body_starts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "sim/contact/tissue/tissue_surface.h"

namespace fascia {
namespace {

constexpr double kUnitsOfWeight = 1 << 18;  // 1 / SUPPORT_UNIT of shaders/sim/contact/support.glsl
constexpr double kUnitsOfWay = 1 << 13;     // 1 / WAY_UNIT
// What forces and ways are counted in, of a model without gravity, too [m/s^2]: UNIT_GRAVITY
constexpr double kLeastUnit = 9.81;
constexpr std::size_t kWords = 21;      // of a body there
constexpr std::size_t kToolWords = 12;  // of them: what tools alone add

}  // namespace

BodyStarts::BodyStarts(const Model& model, const SimBuffers& buffers, const std::vector<std::uint32_t>& points)
    : shares_(std::max<std::size_t>(model.bodies.size(), 1), 1),
      leaders_(shares_.size()),
      own_(buffers.vertex_count, kNoBody),
      points_(points),
      held_(shares_.size()) {
  std::iota(leaders_.begin(), leaders_.end(), 0u);
  const std::vector<char> held = model.held();
  const std::vector<std::uint32_t> bodies = bodies_of_vertices(model);
  for (std::size_t v = 0; v < held.size(); ++v) {
    if (!held[v]) own_[buffers.placement.place[v]] = bodies[v];
    held_[bodies[v]] |= held[v];
  }
  vertices_ = gl::Buffer("contact_body", std::vector<std::uint32_t>(2 * own_.size()));
  bodies_ = gl::Buffer("contact_bodies", std::vector<std::uint32_t>(kWords * shares_.size() + 2 * points_.size()));
  upload_leaders();
  materials_changed(model);
}

void BodyStarts::materials_changed(const Model& model) {
  masses_.assign(shares_.size(), 0);
  const std::vector<std::uint32_t> bodies = bodies_of_vertices(model);
  const std::vector<double> masses = lumped_masses(model);
  for (std::size_t v = 0; v < masses.size(); ++v)
    if (!held_[bodies[v]]) masses_[bodies[v]] += masses[v];
}

void BodyStarts::begin(const Eigen::Vector3d& gravity, const PairStage& pairs) {
  std::fill(shares_.begin(), shares_.end(), 1.0f);
  if (!pairs.empty()) pairs.limit(shares_, leaders_);
  upload_leaders();
  std::vector<std::uint32_t> values;
  for (const float share : shares_) values.push_back(std::bit_cast<std::uint32_t>(share));
  const std::vector<PairStage::Support> supports = pairs.supports(shares_.size());
  const auto add = [&](double value) {
    constexpr double kMost = 1 << 30;
    values.push_back(
        std::bit_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(std::clamp(value, -kMost, kMost)))));
  };
  const double unit = std::max(gravity.norm(), kLeastUnit), fall = pairs.duration() * pairs.duration() * unit;
  for (std::size_t body = 0; body < shares_.size(); ++body) {
    const double weight = masses_[body] * unit;
    for (const double force : supports[body].force) add(weight > 0 ? kUnitsOfWeight * force / weight : 0);
    for (const double way : supports[body].way) add(weight > 0 && fall > 0 ? kUnitsOfWay * way / fall : 0);
    values.push_back(weight > 0 ? supports[body].count : 0);
    values.insert(values.end(), kToolWords, 0);  // other tissue is no tool
  }
  for (const double mass : masses_) values.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(mass)));
  bodies_.upload(0, values.size() * sizeof(std::uint32_t), values.data());
}

bool BodyStarts::meets() const {
  return std::any_of(shares_.begin(), shares_.end(), [](float share) { return share < 1; });
}

void BodyStarts::stay() {
  const std::vector<float> none(kWords *
                                shares_.size());  // no share, nothing that carries, nor a mass that would be carried
  bodies_.upload(0, none.size() * sizeof(float), none.data());
}

void BodyStarts::upload_leaders() {
  if (leaders_ == uploaded_leaders_) return;
  uploaded_leaders_ = leaders_;
  std::vector<std::uint32_t> of_vertices, of_points;
  for (const std::uint32_t body : own_)
    of_vertices.insert(of_vertices.end(), {body == kNoBody ? body : leaders_[body], body});
  vertices_.upload(0, of_vertices.size() * sizeof(std::uint32_t), of_vertices.data());
  for (const std::uint32_t vertex : points_) of_points.push_back(of_vertices[2 * vertex]);
  for (const std::uint32_t vertex : points_) of_points.push_back(own_[vertex]);
  if (!of_points.empty())
    bodies_.upload(kWords * shares_.size() * sizeof(float), of_points.size() * sizeof(std::uint32_t), of_points.data());
}

}  // namespace fascia
