#include "sim/gpu/readback/step_snapshot.h"

namespace fascia {
void StepSnapshot::request(const SimBuffers& buffers) {
  const std::size_t bytes = sizeof(shared::vec4) * buffers.vertex_count;
  const auto copy = [&](gl::Buffer& to, const char* label, const gl::Buffer& from) {
    if (!to) to = gl::Buffer::staging(label, bytes);
    to.copy(from, bytes);
  };
  copy(previous_, "snapshot_previous", buffers.start_of_stage());
  copy(from_, "snapshot_from", buffers.previous_displacement);
  copy(predicted_, "snapshot_predicted", buffers.predicted);
  copy(solution_, "snapshot_solution", buffers.displacement);
  fence_.set();
}

std::optional<SolvedStep> StepSnapshot::take(const SimBuffers& buffers, bool wait) {
  if (!fence_.take(wait)) return std::nullopt;
  return SolvedStep{buffers.download_vectors(previous_), buffers.download_vectors(from_),
                    buffers.download_vectors(predicted_), buffers.download_vectors(solution_)};
}

}  // namespace fascia
