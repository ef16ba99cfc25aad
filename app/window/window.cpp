#include "app/window/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/overlay/color_bar.h"
#include "app/panels/panels.h"
#include "app/system/paths.h"
#include "app/system/user_files.h"
#include "app/ui/style.h"
#include "app/window/compile_notice.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "render/supersampler.h"
#include "sim/simulation/divergence.h"

namespace fascia {
namespace {

constexpr double kLongestWait = 1;  // [s] to look after signals and the device, which do not wake a window
// [s] between frames while something is under way that no event will tell of
constexpr double kUnsettledWait = 1.0 / 30;
constexpr int kFramesToSettle = 3;        // after an event: panels find their size and what they show over some frames
constexpr double kShortestFrame = 0.004;  // [s] where the display does not set the pace

}  // namespace

Window::Window(Graphics& graphics, const ViewOptions& options, Opened opened)
    : graphics_(graphics),
      options_(options),
      input_(graphics.context->window()),
      overlay_(graphics),
      user_(options.steps || options.time ? std::filesystem::path()
                                          : config_folder()),  // a scripted window leaves nothing
      autosave_(options.steps || options.time ? std::filesystem::path() : state_folder()),
      dialogs_(graphics.data_dir, user_),
      gallery_(graphics.data_dir),
      hints_(user_),
      samples_(options.samples > 0     ? std::min(options.samples, samples_of_renderer())
               : gl::device().software ? 1
                                       : 4) {
  state_.video.width = options.width;  // as asked for, whatever the window has got
  state_.video.height = options.height;
  if (user_.now().light) ui::set_theme(ui::Theme::light);
  try {
    OpeningScreen screen(graphics_, overlay_, opened.scene.file.filename().string());
    session_ = make_session(opened, screen, 0);
  } catch (const Cancelled& cancelled) {
    say(cancelled.name + " was not opened");
    opened = open_file(default_scene(graphics.data_dir));
    session_ =
        std::make_unique<Session>(graphics_, std::move(opened.scene), std::move(opened.model), options_.reference);
  }
  if (options.static_equilibrium) {
    const StaticReport report = session_->simulation.solve_static();
    if (!options.quiet || !report.converged) std::cerr << "fascia: " << describe(report) << '\n';
    state_.paused = true;
  }
  if (options.steps || options.time) steps_left_ = steps_to_run(options, session_->simulation);
  session_began();
  dialogs_.opened(session_->simulation.scene.file);
  if (!user_.warning().empty()) say(user_.warning() + ". Went on without it", true);
  recovered_ = autosave_.left_behind();
  dialogs_.set_last_session(autosave_.last());
  if (!user_.now().first_run_done && !config_folder().empty() && options.input.empty() && options.replay.empty() &&
      steps_left_ < 0)
    gallery_.ask();
  glfwSwapInterval(1);
}

void Window::run() {
  GLFWwindow* window = graphics_.context->window();
  Clock::time_point last = Clock::now();
  const Clock::time_point start = last;
  while (!glfwWindowShouldClose(window) && !interrupted() && steps_left_ != 0) {
    wait_for_events();
    require_device();
    if (frames_to_settle_ == 0 && idle_time() > 0) {
      if (!settled_) {
        settle();
        continue;
      }
      attempt([&] { remember_now_and_then(); });
      attempt([&] { follow_recording(); });
      last = Clock::now();
      pacing_.restart();
      continue;
    }
    const Clock::time_point now = Clock::now();
    const double elapsed = std::chrono::duration<double>(now - last).count();
    if (elapsed < kShortestFrame) {
      glfwWaitEventsTimeout(kShortestFrame - elapsed);
      continue;
    }
    last = now;
    if (frames_to_settle_ > 0)
      --frames_to_settle_;
    else
      settled_ = false;
    state_.statistics.frame.add(1000 * elapsed);
    frame(elapsed);
    require_device();
    attempt([&] { remember_now_and_then(); });
  }
  stats_.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  attempt([&] { find_last_residual(); });
  attempt([&] { remember(); });
  attempt([&] { autosave_.finish(); });
  attempt([&] { end_recording(); });
  stats_.renderer = session_->renderer_description();
  stats_.provenance = provenance();
  stats_.solve_ms = stats_.step_ms;
  count_work(stats_, session_->simulation);
}

void Window::find_last_residual() {
  GpuSolver& solver = *session_->simulation.gpu();
  if (diagnose_) solver.request_diagnostics();
  if (const auto last = solver.take_diagnostics(true)) stats_.residual = last->residual;
}

bool Window::asleep() const { return session_->simulation.asleep() && (!split_ || split_->asleep()); }

bool Window::still() const {
  const Simulation& simulation = session_->simulation;
  return state_.paused || (asleep() && steps_left_ < 0 && !simulation.awaits_grabs());
}

void Window::require_device() const {
  try {
    gl::require_context();
  } catch (const gl::ContextLost& lost) {
    if (!remembered_) throw;
    throw gl::ContextLost(std::string(lost.what()) + ". The scene is kept in " + keep_replay(*remembered_).string());
  }
}

double Window::idle_time() const {
  if (glfwGetWindowAttrib(graphics_.context->window(), GLFW_ICONIFIED)) return kLongestWait;
  const bool under_way = video_.running() || session_->true_error.busy() || (split_ && split_->busy()) ||
                         session_->simulation.gpu()->diagnosing();
  if (!still() || under_way || ImGui::IsAnyItemActive()) return 0;
  if (!message_) return kLongestWait;
  return std::clamp(std::chrono::duration<double>(message_->until - Clock::now()).count(), 0.0, kLongestWait);
}

void Window::wait_for_events() {
  const double idle = frames_to_settle_ > 0 ? 0 : idle_time();
  if (idle > 0)
    glfwWaitEventsTimeout(idle);
  else if (shown_ && ((still() && !mouse_.dragging()) || !session_->simulation.ready()))
    glfwWaitEventsTimeout(kUnsettledWait);
  else
    glfwPollEvents();
  if (!input_.take_wake()) return;
  frames_to_settle_ = kFramesToSettle;
  settled_ = false;
}

// Before the window waits: numbers that the GPU gives back some frames late have come, and what is shown is drawn once
// more with them.
void Window::settle() {
  attempt([&] { session_->settle_range(split_ ? &split_->b() : nullptr); });
  frames_to_settle_ = kFramesToSettle;
  settled_ = true;
}

bool Window::attempt(const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const Cancelled& cancelled) {
    say(cancelled.name + " was not opened");
  } catch (const std::bad_alloc&) {
    say("Out of memory", true);
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
  return false;
}

void Window::say(const std::string& text, bool is_error) {
  message_ = Message{text, is_error, Clock::now() + std::chrono::seconds(is_error ? 3600 : 4)};
}

void Window::frame(double elapsed) {
  if (!update_framebuffer()) {
    input_.discard();
    pacing_.restart();
    return;
  }
  Requests requests;
  do {
    requests = {};
    if (message_ && message_->is_error && input_.take_key(GLFW_KEY_ESCAPE))
      message_.reset();  // it lies in front of all else
    overlay_.begin(framebuffer_->width(), framebuffer_->height());
    const Camera view = session_->camera;
    attempt([&] { handle_input(requests); });
    if (view.eye != session_->camera.eye || view.target != session_->camera.target) state_.replay_camera = false;
    attempt([&] { build_panels(requests); });
    panels_take_escape_ = ImGui::IsAnyItemActive() ||
                          ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    overlay_.end();
    attempt([&] { carry_out(requests); });
  } while (input_.waiting() && !requests.wait_for_picture());
  if (shown_ && !attempt([&] { simulate(elapsed, requests); })) state_.paused = true;
  attempt([&] { follow_replay(); });
  if (!attempt([&] { draw(); })) state_.paused = true;
  overlay_.draw(*framebuffer_);
  attempt([&] { capture(requests); });
  attempt([&] { follow_recording(); });
  overlay_.draw_foreground(*framebuffer_);
  framebuffer_->present(framebuffer_->width(), framebuffer_->height());
  glfwSwapBuffers(graphics_.context->window());
  shown_ = true;
}

bool Window::update_framebuffer() {
  GLFWwindow* window = graphics_.context->window();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  if (width < 1 || height < 1 || glfwGetWindowAttrib(window, GLFW_ICONIFIED)) return false;
  if (framebuffer_ && framebuffer_->width() == width && framebuffer_->height() == height) return true;
  framebuffer_.reset();  // before the new one: two large ones may not fit
  try {
    framebuffer_ = std::make_unique<Framebuffer>(width, height, samples_);
  } catch (const Error&) {
    if (samples_ <= 1) throw;
    framebuffer_ = std::make_unique<Framebuffer>(width, height, 1);
    say("No memory for " + std::to_string(samples_) + " samples per pixel: drawn with one", true);
    samples_ = 1;
  }
  return true;
}

void Window::build_panels(Requests& requests) {
  Statistics& s = state_.statistics;
  s.speed = pacing_.speed();
  s.keeps_pace = pacing_.keeps_pace();
  state_.recording = video_.running();
  state_.grabs = mouse_.grabs().all().size();
  const Room room = room_beside_panels(state_);
  const bool shown_alone = video_.running() && !video_.settings().panels;  // the scene, in a video
  if (!shown_alone) draw_notice(state_, room);
  if (state_.show_panels) {
    draw_panels({tuned(), state_, requests});
    if (steps_left_ < 0 && !shown_alone && !split_) draw_hints(hints_, room);  // where a comparison has its figures
  }
  if (state_.plots.shown) draw_plots(session_->simulation, state_, requests);
  if (session_->simulation.replaying()) draw_replay_badge(session_->simulation, state_, requests);
  if (state_.show_recording) draw_recording_settings(state_, requests);
  if (state_.show_help) draw_help(state_);
  dialogs_.draw(requests);
  if (gallery_.draw(requests)) user_.change([](UserSettings& settings) { settings.first_run_done = true; });
  if (recovered_) draw_recovery(Autosave::name_in(*recovered_), requests);
  follow_hints();
  if (const bool light = ui::theme() == ui::Theme::light; light != user_.now().light)
    user_.change([&](UserSettings& settings) { settings.light = light; });
  const bool news = message_ && !message_->is_error;
  // A screenshot shows the scene, not the news of the screenshot before it.
  if (message_ && !(news && requests.screenshot) &&
      (draw_message(message_->text, message_->is_error) || Clock::now() > message_->until))
    message_.reset();
  if (video_.running()) draw_recording_dot(video_.seconds(), video_.dropped());
  if (split_) split_->share(*session_);
  follow_tunables();
}

void Window::make_step() {
  mouse_.pull(held());
  if ((state_.show_panels && state_.show_convergence) || shows_convergence(state_.plots))
    state_.convergence.measure(tuned().simulation, *graphics_.programs);
  const bool slept = asleep();
  if (split_)
    split_->step(*session_, held());
  else
    session_->simulation.step();
  simulated_ += session_->simulation.scene.solver.time_step;
  diagnose_ |= !slept || !asleep();  // also the step after which it sleeps
  ++state_.statistics.steps;
  ++stats_.steps;
  if (steps_left_ > 0) --steps_left_;
}

void Window::simulate(double elapsed, const Requests& requests) {
  Statistics& s = state_.statistics;
  const double time_step = session_->simulation.scene.solver.time_step;
  int steps = 0;
  const bool ready = session_->simulation.ready();
  s.waits = ready ? 0 : s.waits + elapsed;
  if (!state_.paused && ready) {
    const bool replaying = session_->simulation.replaying();
    steps = pacing_.advance(elapsed * (replaying ? state_.replay_speed : 1), time_step, s.step_ms / 1000);
    if (replaying)
      steps = static_cast<int>(
          std::min<long>(steps, session_->simulation.replay()->steps - session_->simulation.replayed_steps()));
  } else {
    pacing_.restart();
    steps = state_.paused && requests.step ? 1 : 0;
  }
  if (steps_left_ >= 0) steps = static_cast<int>(std::min<long>(steps, steps_left_));
  simulated_ = 0;
  const bool repeats = session_->simulation.repeating();
  if (steps > 0) {
    const CompileNotice notice(graphics_, overlay_, *framebuffer_, panels_cover());
    solve_timer_.begin();
    for (int i = 0; i < steps; ++i) make_step();
    solve_timer_.end(steps, notice.kernels() > 0);
  }
  while (const auto took = solve_timer_.take())
    s.add_steps(took->milliseconds, took->steps, took->compiled, stats_.step_ms);
  if (still()) pacing_.forget_speed();  // nothing is solved that could be slow
  if (repeats) accept_tunables();
  if (const auto lost = session_->simulation.diverged()) go_back(*lost);
  read_diagnostics();
  const bool follow = tuned().follow_true_error;  // of both sides
  session_->follow_true_error = follow;
  session_->follow_error();
  if (split_) {
    split_->b().follow_true_error = follow;
    split_->b().follow_error();
  }
}

// Once or twice the tissue starts again where all was well, at rest and let go. What then comes apart again would do so
// for ever.
void Window::go_back(std::uint32_t lost) {
  constexpr long kForgiven = 600;  // steps
  constexpr long kMostTimes = 3;
  Simulation& simulation = session_->simulation;
  divergences_ = simulation.steps_made() - diverged_at_ > kForgiven ? 1 : divergences_ + 1;
  diverged_at_ = simulation.steps_made();
  let_go();
  session_->true_error.forget();
  diagnose_ = true;
  if (divergences_ < kMostTimes) {
    simulation.back_to_valid();
    simulation.begin_anew();
    if (split_) split_->restart_from(*session_);
    say("The tissue came apart: back to the last sound state, at rest");
    return;
  }
  state_.paused = true;
  divergences_ = 0;
  try {
    simulation.require_device();
  } catch (const Error& error) {
    return say(error.what(), true);
  }
  const Divergence divergence = find_divergence(simulation, lost);
  const std::string text =
      divergence.text(simulation.model) + ". Paused at the last sound state; R goes back to the start. ";
  say(text + "More iterations or substeps, or softer tissue, may help", true);
  say(text + keep_replay(divergence.replay).string() + " repeats it", true);
}

void Window::remember_now_and_then() {
  if (!remembered_ || autosave_.due()) remember();
}

void Window::remember() {
  Simulation& simulation = session_->simulation;
  Scene scene = scene_now();
  std::string text = parameters_to_json(scene, {});
  const long step = simulation.uses_reference() ? simulation.steps_made() : simulation.gpu()->steps_solved();
  const bool same = remembered_ && step == remembered_step_ && text == remembered_scene_;
  autosave_.wait_a_while();
  if (same) return;
  const std::string name = scene.file.stem().string();
  remembered_ = std::make_shared<const Replay>(
      Replay{std::move(scene), simulation.uses_reference() ? simulation.state() : simulation.last_valid(), {}, 0});
  remembered_scene_ = std::move(text);
  remembered_step_ = step;
  autosave_.keep(remembered_, name);
}

}  // namespace fascia
