#include "sim/gpu/readback/step_snapshot.h"

namespace fascia {
void StepSnapshot::request(const SimBuffers& buffers) {
  const std::size_t bytes = sizeof(shared::vec4) * buffers.vertex_count;
  const auto copy = [&](gl::Buffer& to, const char* label, const gl::Buffer& from, std::size_t size) {
    if (!to) to = gl::Buffer::staging(label, size);
    to.copy(from, size);
  };
  copy(previous_, "snapshot_previous", buffers.start_of_stage(), bytes);
  copy(from_, "snapshot_from", buffers.previous_displacement, bytes);
  copy(predicted_, "snapshot_predicted", buffers.predicted, bytes);
  copy(solution_, "snapshot_solution", buffers.displacement, bytes);
  if (buffers.contact_before)
    copy(contact_, "snapshot_contact", buffers.contact_before, buffers.contact_before.bytes());
  fence_.set();
}

std::optional<SolvedStep> StepSnapshot::take(const SimBuffers& buffers, bool wait) {
  if (!fence_.take(wait)) return std::nullopt;
  return SolvedStep{buffers.download_vectors(previous_), buffers.download_vectors(from_),
                    buffers.download_vectors(predicted_), buffers.download_vectors(solution_),
                    contact_ ? buffers.contact_forces(contact_) : ContactMemory()};
}

}  // namespace fascia
