#include "sim/gpu/contact/tool_watch.h"

#include <bit>
#include <cmath>

#include "sim/contact/tissue/tissue_cover.h"
#include "sim/gpu/passes/reduction.h"
#include "sim/tool/followed_place.h"
#include "sim/tool/tool_near_box.h"

namespace fascia {
namespace {

// Of the size: what forces add to the motion of a step in every step. At 60 steps a second and 20 cm, 36 m/s^2.
constexpr double kGain = 0.05;

float from_ordered(std::uint32_t bits) {
  return std::bit_cast<float>((bits & 0x80000000u) != 0 ? bits ^ 0x80000000u : ~bits);
}

}  // namespace

ToolWatch::ToolWatch(gl::ProgramCache& programs, const SimBuffers& buffers)
    : buffers_(buffers),
      bounds_("tissue_bounds", 7 * sizeof(std::uint32_t)),
      measure_(programs.compute("sim/readback/bounds.comp"),
               gl::ComputePass::Bindings{{"rest_position", &buffers.rest_position},
                                         {"displacement", &buffers.displacement},
                                         {"velocity", &buffers.velocity},
                                         {"bounds", &bounds_}},
               Reduction(programs, buffers.vertex_count).lanes,
               gl::ComputePass::Constants{{"vertex_count", buffers.vertex_count}}) {}

void ToolWatch::read() {
  bounds_.clear();
  measure_.run();
  const auto bounds = bounds_.read<std::uint32_t>();
  for (std::size_t k = 0; k < 3; ++k) {
    box_.max()[static_cast<Eigen::Index>(k)] = from_ordered(bounds[k]);
    box_.min()[static_cast<Eigen::Index>(k)] = -from_ordered(bounds[3 + k]);
  }
  speed_ = std::sqrt(from_ordered(bounds[6]));
  age_ = 0;
}

bool ToolWatch::is_near(const Model& model, const Step& step, int age) const {
  const double inertial = step.duration * step.duration * step.gravity.norm(), gain = kGain * buffers_.size;
  double reach = kContactMargin * buffers_.size + 0.5 * model.contact.thickness;
  for (int k = 0; k <= age; ++k) reach += 2 * (step.duration * speed_ + (k + 1) * inertial) + k * gain;
  Eigen::AlignedBox3d box = box_;
  box.extend(step.led);
  for (std::size_t t = 0; t < model.tools.size(); ++t) {
    const ToolPlace &from = step.tools.from[t], &to = step.tools.to[t];
    const double way = way_between(model.tools[t], from, to, buffers_.size);
    if (!std::isfinite(reach) || is_near_box(model.tools[t], from, box, reach + way)) return true;
  }
  return false;
}

bool ToolWatch::is_near(const Model& model, const Step& step) {
  const bool old = age_ >= kLongest;
  if (old || (!near_ && age_ > 0 && is_near(model, step, age_))) {
    read();
    near_ = is_near(model, step, 0);
  }
  ++age_;
  return near_;
}

}  // namespace fascia
