// What the window waits for: events, while nothing moves, and kernels that are compiled beside its frames.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>

#include "app/view_window.h"

namespace fascia {
namespace {

constexpr double kLongestWait = 1;      // [s] to look after signals and the device, which do not wake a window
constexpr double kUnsettledWait = 1.0 / 30;  // [s] between frames while something is under way that no event will tell of
constexpr int kFramesToSettle = 3;      // after an event: panels find their size and what they show over some frames

}  // namespace

bool ViewWindow::still() const {
  const Simulation& simulation = session_->simulation;
  const bool asleep = simulation.asleep() && (!split_ || split_->asleep());
  return state_.paused || (asleep && steps_left_ < 0 && !simulation.awaits_hands());
}

double ViewWindow::idle_time() const {
  if (glfwGetWindowAttrib(graphics_.context->window(), GLFW_ICONIFIED)) return kLongestWait;
  const bool under_way = step_asked_ || mouse_.waits() || video_.running() || session_->true_error.busy() || (split_ && split_->busy()) || session_->simulation.gpu()->diagnosing();
  if (!still() || under_way || ImGui::IsAnyItemActive()) return 0;
  if (!message_) return kLongestWait;
  return std::clamp(std::chrono::duration<double>(message_->until - Clock::now()).count(), 0.0, kLongestWait);
}

void ViewWindow::wait_for_events() {
  const double idle = frames_to_settle_ > 0 ? 0 : idle_time();
  if (idle > 0)
    glfwWaitEventsTimeout(idle);
  else if (shown_ && ((still() && !mouse_.dragging()) || !may_step()))
    glfwWaitEventsTimeout(kUnsettledWait);
  else
    glfwPollEvents();
  if (input_.take_stir()) frames_to_settle_ = kFramesToSettle;
}

bool ViewWindow::compiled(const Session& session, Rehearsed part) {
  return !warmer_ || warmer_->compiled(session.simulation.scene.solver, session.simulation.model) >= part;
}

bool ViewWindow::may_step() {
  const Simulation& simulation = session_->simulation;
  const bool held = !simulation.springs().empty() || simulation.awaits_hands() || simulation.replaying();
  return simulation.ready() && compiled(*session_, held ? Rehearsed::hands : Rehearsed::steps);
}

// Nothing that waits is an input yet: what is recorded, and what a replay repeats, begins with what pulls.
void ViewWindow::follow_kernels(bool keep_quiet) {
  constexpr auto kPatience = std::chrono::milliseconds(200);  // shorter waits show nothing
  const bool hand_waits = !mouse_.hands().empty() && held().simulation.springs().empty() && !compiled(held(), Rehearsed::hands);
  mouse_.wait(hand_waits, held());
  const bool tissue_waits = !compiled(*session_, Rehearsed::steps);
  state_.waits_for = nullptr;
  if (!hand_waits && !tissue_waits) {
    waits_since_.reset();
    return;
  }
  if (!waits_since_) waits_since_ = Clock::now();
  if (keep_quiet || Clock::now() - *waits_since_ < kPatience) return;
  state_.waits_for = tissue_waits ? "Compiling kernels, once" : "Preparing the hands: kernels are compiled once";
}

}  // namespace fascia
