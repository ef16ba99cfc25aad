// The heat maps that follow from the recovered stress, computed on another thread while frames continue: the error of
// the mesh (sim/accuracy/mesh_error.h) and the von Mises stress at vertices (sim/accuracy/nodal_stress.h).
#pragma once
#include <future>
#include <optional>
#include <stop_token>
#include <vector>

#include "sim/accuracy/nodal_stress.h"
#include "sim/simulation/simulation.h"

namespace fascia {

class RecoveredMap {
 public:
  RecoveredMap() = default;
  RecoveredMap(const RecoveredMap&) = delete;
  RecoveredMap& operator=(const RecoveredMap&) = delete;
  ~RecoveredMap() { forget(); }  // stops the thread and waits for it

  static bool has(ColorBy color) { return color == ColorBy::mesh_error || color == ColorBy::recovered_von_mises; }

  /// Call once per frame while the values of this map are shown: begins an estimate of the current state if none is
  /// pending and the last one is of another state, of other materials or of another map. True when there are new
  /// values.
  bool update(const Simulation& simulation, ColorBy color);
  void measure(const Simulation& simulation, ColorBy color);  // at once
  bool busy() const { return running_.valid(); }
  /// [vertex_count] of this map; empty before its first estimate.
  const std::vector<float>& values(ColorBy color) const {
    static const std::vector<float> none;
    return color_ == color ? shown_.values : none;
  }
  /// Of the recovered stress, while its map is shown; none before its first estimate.
  const std::optional<PeakStress>& peak() const { return shown_.peak; }
  void forget();  // the state has jumped: discards a pending estimate

 private:
  struct Subject {
    ColorBy color;
    long steps;  // in which something moved
    std::vector<Material> materials;
    bool operator==(const Subject&) const = default;
  };

  struct Estimate {
    std::vector<float> values{};  // [vertex_count]
    std::optional<PeakStress> peak{};
  };
  static Estimate estimate(ColorBy color, const Model& model, const State& state, const std::stop_token& stop = {});

  std::optional<Subject> subject_;  // of the last estimate that began
  std::stop_source stop_;
  std::future<Estimate> running_;
  Estimate shown_;
  ColorBy color_ = ColorBy::none, running_color_ = ColorBy::none;  // of shown_, of running_
};

}  // namespace fascia
