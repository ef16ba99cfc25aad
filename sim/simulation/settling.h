// Where a body that has nearly come to rest will lie: its static equilibrium, found in double precision on another
// thread while the steps go on. A slow swing stands still at its turn, and float32 steps stop a ten-thousandth of a
// percent short of the equilibrium; a body that sleeps is put exactly there.
#pragma once
#include <future>
#include <optional>
#include <stop_token>
#include <vector>

#include "sim/reference/newton.h"

namespace fascia {

class Settling {
 public:
  static constexpr std::size_t kMostTets = 20'000;  // whose factor is made within seconds

  Settling() = default;
  Settling(const Settling&) = delete;
  Settling& operator=(const Settling&) = delete;
  ~Settling();  // waits for its threads

  /// Begins before step `step` with `state`; copies all that it needs. Precondition: not busy().
  void begin(const Model& model, const SolverSettings& settings, const std::vector<GrabSpring>& springs, State state,
             long step);
  bool busy() const { return running_.valid(); }
  /// Whether take() is to be called before this step. A number of steps that depends on the mesh alone, so that runs
  /// repeat; by then the search has mostly ended.
  bool due(long step) const { return busy() && step >= due_; }
  /// The equilibrium, waited for; none where Newton's method finds none.
  std::optional<State> take() { return running_.get(); }
  void cancel();  // waits for nothing

 private:
  using Search = std::future<std::optional<State>>;
  Search running_;
  std::vector<Search> cancelled_;  // and not ended yet
  std::stop_source stop_;
  long due_ = 0;
};

}  // namespace fascia
