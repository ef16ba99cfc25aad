#include "sim/simulation/settling.h"

#include <chrono>

#include "base/error.h"

namespace fascia {

void Settling::begin(const Model& model, const SolverSettings& settings, const std::vector<GrabSpring>& springs,
                     State state, long step) {
  std::erase_if(cancelled_, [](const Search& search) {
    return search.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
  stop_ = {};
  const auto tets = static_cast<long>(model.tets.size());
  due_ = step + 32 + tets / 100;  // about half a second, and four seconds with 20,000 tets
  const auto search = [model, settings, springs, state = std::move(state),
                       stop = stop_.get_token()]() mutable -> std::optional<State> {
    try {
      const double time = state.time;
      reference::NewtonSolver solver(model, settings, stop);
      solver.set_springs(springs);
      if (!solver.solve_static(state).converged) return std::nullopt;
      state.time = time;
      return state;
    } catch (const Error&) {  // gravity acts on an unconstrained component
      return std::nullopt;
    }
  };
  running_ = std::async(std::launch::async, search);
}

void Settling::cancel() {
  if (!running_.valid()) return;
  stop_.request_stop();
  cancelled_.push_back(std::move(running_));
  running_ = {};
}

Settling::~Settling() {
  stop_.request_stop();  // the futures wait for their threads
}

}  // namespace fascia
