#include "sim/gpu/readback/tangle_watch.h"

#include <bit>

#include "sim/gpu/passes/features.h"
#include "sim/gpu/passes/reduction.h"

namespace fascia {
namespace {

constexpr double kUprightRatio = 0.3;  // J
constexpr double kLongest = 2;         // [s]

}  // namespace

void Easing::look(double least, double time, bool handled) {
  if (handled) armed_ = true;
  if (least > kUprightRatio) {
    hardness_ = Hardness::own;
    armed_ = true;
  } else if (hardness_ == Hardness::eased) {
    if (handled) {
      until_ = time + kLongest;
    } else if (time >= until_) {
      hardness_ = Hardness::own;
      armed_ = false;
    }
  } else if (least <= 0) {
    hardness_ = armed_ ? Hardness::eased : Hardness::firm;
    until_ = time + kLongest;
  } else if (armed_) {
    hardness_ = Hardness::own;
  }
}

TangleWatch::TangleWatch(gl::ProgramCache& programs, const SimBuffers& buffers)
    : compression_("compression", sizeof(std::uint32_t)),
      read_back_(gl::Buffer::staging("compression_read_back", sizeof(std::uint32_t))) {
  gl::ComputePass::Bindings bindings{{"displacement", &buffers.displacement}, {"compression", &compression_}};
  if (buffers.has_linear()) {
    gl::ComputePass::Bindings linear = bindings;
    linear.insert(linear.end(), {{"tet_vertices", &buffers.tet_vertices}, {"tet_shape", &buffers.tet_shape}});
    measures_.emplace_back(programs.compute("sim/readback/compression.comp"), std::move(linear),
                           Reduction(programs, buffers.linear_count(), true).lanes,
                           gl::ComputePass::Constants{{"tet_count", buffers.linear_count()}});
  }
  if (!buffers.has_quadratic()) return;
  gl::ComputePass::Constants constants = constants_of_quadratic(buffers);
  constants.emplace_back("quadratic_count", buffers.quadratic_count);
  measures_.emplace_back(
      programs.compute("sim/quadratic/quadratic_compression.comp", defines_of_quadratic({}, buffers)),
      with_quadratic(std::move(bindings), buffers), Reduction(programs, buffers.quadratic_count, true).lanes,
      std::move(constants));
}

Hardness TangleWatch::hardness(double time, bool handled) {
  if (age_ >= kInterval) {
    if (fence_.take(true))
      easing_.look(1 - static_cast<double>(std::bit_cast<float>(read_back_.read<std::uint32_t>().front())), time,
                   handled);
    compression_.clear();
    for (const gl::ComputePass& measure : measures_) measure.run();
    read_back_.copy(compression_, sizeof(std::uint32_t));
    fence_.set();
    age_ = 0;
  }
  ++age_;
  return easing_.hardness();
}

void TangleWatch::restart() {
  fence_.clear();
  easing_ = {};
  age_ = kInterval;
}

}  // namespace fascia
