#include "sim/gpu/step_snapshot.h"

namespace fascia {
namespace {

std::vector<Eigen::Vector3d> vectors_of(const gl::Buffer& buffer) {
  std::vector<Eigen::Vector3d> vectors;
  for (const shared::vec4& v : buffer.read<shared::vec4>()) vectors.emplace_back(v.x, v.y, v.z);
  return vectors;
}

}  // namespace

StepSnapshot::~StepSnapshot() {
  if (fence_) gl::DeleteSync(fence_);
}

void StepSnapshot::request(const SimBuffers& buffers) {
  const std::size_t bytes = sizeof(shared::vec4) * buffers.vertex_count;
  const auto copy = [&](gl::Buffer& to, const char* label, const gl::Buffer& from) {
    if (!to) to = gl::Buffer(label, bytes);
    to.copy(from, bytes);
  };
  copy(previous_, "snapshot_previous", buffers.previous_displacement);
  copy(predicted_, "snapshot_predicted", buffers.predicted);
  copy(solution_, "snapshot_solution", buffers.displacement);
  if (fence_) gl::DeleteSync(fence_);
  fence_ = gl::FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

std::optional<SolvedStep> StepSnapshot::take(bool wait) {
  if (!fence_) return std::nullopt;
  if (gl::ClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, wait ? GLuint64(10'000'000'000) : 0) == GL_TIMEOUT_EXPIRED)
    return std::nullopt;
  gl::DeleteSync(fence_);
  fence_ = nullptr;
  return SolvedStep{vectors_of(previous_), vectors_of(predicted_), vectors_of(solution_)};
}

}  // namespace fascia
