// The error of the mesh at each vertex (sim/accuracy/mesh_error.h), estimated on another thread while frames continue.
#pragma once
#include <future>
#include <optional>
#include <stop_token>
#include <vector>

#include "sim/simulation/simulation.h"

namespace fascia {

class MeshErrorMap {
 public:
  MeshErrorMap() = default;
  MeshErrorMap(const MeshErrorMap&) = delete;
  MeshErrorMap& operator=(const MeshErrorMap&) = delete;
  ~MeshErrorMap() { forget(); }  // stops the thread and waits for it

  /// Call once per frame while the values are shown: begins an estimate of the current state if none is pending and
  /// the last one is of another state or of other materials. True when there are new values.
  bool update(const Simulation& simulation);
  void measure(const Simulation& simulation);  // at once
  bool busy() const { return running_.valid(); }
  /// [vertex_count]; empty before the first estimate.
  const std::vector<float>& values() const { return values_; }
  void forget();  // the state has jumped: discards a pending estimate

 private:
  struct Subject {
    long steps;  // in which something moved
    std::vector<Material> materials;
    bool operator==(const Subject&) const = default;
  };

  std::optional<Subject> subject_;  // of the last estimate that began
  std::stop_source stop_;
  std::future<std::vector<float>> running_;
  std::vector<float> values_;
};

}  // namespace fascia
