#include "sim/gpu/step_snapshot.h"

namespace fascia {
void StepSnapshot::request(const SimBuffers& buffers) {
  const std::size_t bytes = sizeof(shared::vec4) * buffers.vertex_count;
  const auto copy = [&](gl::Buffer& to, const char* label, const gl::Buffer& from) {
    if (!to) to = gl::Buffer(label, bytes);
    to.copy(from, bytes);
  };
  copy(previous_, "snapshot_previous", buffers.previous_displacement);
  copy(predicted_, "snapshot_predicted", buffers.predicted);
  copy(solution_, "snapshot_solution", buffers.displacement);
  fence_.set();
}

std::optional<SolvedStep> StepSnapshot::take(bool wait) {
  if (!fence_.take(wait)) return std::nullopt;
  const auto vectors_of = [](const gl::Buffer& buffer) { return download_vectors(buffer, buffer.bytes() / sizeof(shared::vec4)); };
  return SolvedStep{vectors_of(previous_), vectors_of(predicted_), vectors_of(solution_)};
}

}  // namespace fascia
