// Finds the static equilibrium of a body that has nearly come to rest, in double precision on another thread while the
// steps continue. A slow oscillation stands still at its turning point, and float32 steps stop a ten-thousandth of a
// percent short of the equilibrium; a body that falls asleep is put exactly there.
#pragma once
#include <future>
#include <optional>
#include <stop_token>
#include <vector>

#include "sim/reference/newton.h"

namespace fascia {

class Settling {
 public:
  static constexpr std::size_t kMostTets = 20'000;  // largest mesh whose factor takes only seconds

  Settling() = default;
  Settling(const Settling&) = delete;
  Settling& operator=(const Settling&) = delete;
  ~Settling();  // waits for its threads

  /// Begins before step `step` with `state`; copies all inputs. Precondition: not busy().
  void begin(const Model& model, const SolverSettings& settings, const std::vector<GrabSpring>& springs, State state,
             long step);
  bool busy() const { return running_.valid(); }
  /// Whether take() must be called before this step. The number of steps depends only on the mesh, so that runs repeat;
  /// by then the search has usually ended.
  bool due(long step) const { return busy() && step >= due_; }
  /// Waits for the equilibrium; none if Newton's method finds none.
  std::optional<State> take() { return running_.get(); }
  void cancel();  // does not wait

 private:
  using Search = std::future<std::optional<State>>;
  Search running_;
  std::vector<Search> cancelled_;  // that have not ended yet
  std::stop_source stop_;
  long due_ = 0;
};

}  // namespace fascia
