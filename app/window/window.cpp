#include "app/window/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <iostream>

#include "app/system/paths.h"
#include "app/system/user_files.h"
#include "app/ui/units.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/text.h"

namespace fascia {
namespace {

constexpr double kLongestWait = 1;  // [s] between checks of signals and of the device, which do not wake a window
// [s] between frames while work is pending that no event reports
constexpr double kUnsettledWait = 1.0 / 30;
constexpr int kFramesToSettle = 3;        // after an event: the layout of panels settles over some frames
constexpr double kShortestFrame = 0.004;  // [s] if the display does not limit the frame rate

bool scripted(const ViewOptions& options) { return options.steps || options.time; }

// A scripted window keeps no record. A static equilibrium has more digits than the state from which steps continue.
bool recorded(const ViewOptions& options) { return !scripted(options) && !options.static_equilibrium; }

}  // namespace

Window::Window(Graphics& graphics, const ViewOptions& options, Opened opened)
    : graphics_(graphics),
      input_(graphics.context->window()),
      overlay_(graphics),
      stage_{options.command_line},
      sides_(graphics, stage_),
      recording_(stage_, sides_, recorded(options)),
      tuning_(graphics, stage_, sides_, recording_, kernels_),
      observer_(stage_, sides_),
      picture_(graphics, overlay_, stage_, sides_, observer_, options.samples),
      capture_(stage_, picture_),
      recovery_(stage_, sides_, scripted(options) ? std::filesystem::path() : state_folder()),
      panels_(stage_, sides_, capture_, recovery_, graphics.data_dir, scripted(options)),
      controls_(input_, stage_, sides_, observer_, recording_),
      stepping_(graphics, overlay_, stage_, sides_),
      kernels_(graphics, !scripted(options), state_folder()),
      opener_(graphics, overlay_, options.reference, kernels_),
      log_(options.frame_log),
      governor_(gl::device().software && options.quality != "full" && !scripted(options)),
      frames_to_settle_(kFramesToSettle) {
  stage_.state.video.width = options.width;  // the requested size, independent of the window's size
  stage_.state.video.height = options.height;
  try {
    stage_.session = opener_.make(std::move(opened));
  } catch (const Cancelled& cancelled) {
    stage_.messages.say(cancelled.name + " was not opened");
    Opened other = open_file(default_scene(graphics.data_dir));
    stage_.session =
        std::make_unique<Session>(graphics, std::move(other.scene), std::move(other.model), options.reference);
  }
  const std::string& other_device = graphics.context->other_device;
  if (options.device >= 0 && !other_device.empty()) stage_.messages.say(other_device);
  if (options.static_equilibrium) {
    const StaticReport report = stage_.simulation().solve_static();
    if (!options.quiet || !report.converged) std::cerr << "fascia: " << describe(report) << '\n';
    stage_.state.paused = true;
  }
  if (!options.measured.empty()) observer_.show_measured(options.measured);
  if (scripted(options)) stepping_.limit(steps_to_run(options, stage_.simulation()));
  session_began();
  recovery_.look_for_left();
  panels_.begin(options.input.empty() && options.replay.empty());
  glfwSwapInterval(1);
}

void Window::run() {
  using Clock = std::chrono::steady_clock;
  GLFWwindow* window = graphics_.context->window();
  Clock::time_point last = Clock::now();
  const Clock::time_point start = last;
  while (!glfwWindowShouldClose(window) && !interrupted() && !stepping_.done()) {
    wait_for_events();
    recovery_.require_device();
    if (frames_to_settle_ == 0 && idle_time() > 0) {
      if (!settled_) {
        settle();
        continue;
      }
      stage_.messages.attempt([&] { recovery_.remember_now_and_then(); });
      stage_.messages.attempt([&] { recording_.follow(); });
      follow_kernels();
      if (observer_.follow_fit()) frames_to_settle_ = kFramesToSettle;
      last = Clock::now();
      stage_.pacing.restart();
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
    stage_.state.statistics.frame.add(1000 * elapsed);
    frame(elapsed);
    recovery_.require_device();
    stage_.messages.attempt([&] { recovery_.remember_now_and_then(); });
  }
  finish(std::chrono::duration<double>(Clock::now() - start).count());
}

void Window::finish(double wall_s) {
  stage_.messages.attempt([&] { observer_.finish(); });
  stage_.messages.attempt([&] { recovery_.remember(); });
  stage_.messages.attempt([&] { recovery_.finish(); });
  stage_.messages.attempt([&] { recording_.end(); });
  log_.write();
  RunStats& stats = stepping_.stats();
  stats.wall_s = wall_s;
  stats.residual = observer_.residual();
  if (const auto& last = observer_.of_open_session()) {
    stats.tool_loads = last->tool_loads;
    stats.pair_loads = last->pair_loads;
  }
  stats.renderer = stage_.session->renderer_description();
  stats.provenance = stage_.provenance();
  stats.solve_ms = stats.step_ms;
  count_work(stats, stage_.simulation());
}

double Window::idle_time() const {
  if (glfwGetWindowAttrib(graphics_.context->window(), GLFW_ICONIFIED)) return kLongestWait;
  const SplitView* split = sides_.split();
  const bool under_way = capture_.video().running() || stage_.session->measuring_error() || (split && split->busy()) ||
                         stage_.simulation().gpu()->diagnosing();
  if (!stepping_.still() || under_way || ImGui::IsAnyItemActive()) return 0;
  return std::clamp(stage_.messages.seconds_left(), 0.0, kLongestWait);
}

void Window::wait_for_events() {
  const double idle = frames_to_settle_ > 0 ? 0 : idle_time();
  if (idle > 0)
    glfwWaitEventsTimeout(idle);
  else if (shown_ &&
           ((stepping_.still() && !stage_.mouse.dragging() && !stage_.hand.dragging()) || !stage_.simulation().ready()))
    glfwWaitEventsTimeout(kUnsettledWait);
  else
    glfwPollEvents();
  if (!input_.take_wake()) return;
  frames_to_settle_ = kFramesToSettle;
  settled_ = false;
}

// Before the window waits: fetches the numbers that the GPU returns some frames late, and draws the picture once more
// with them.
void Window::settle() {
  stage_.messages.attempt([&] {
    stage_.session->settle_range(sides_.second());
    stage_.session->lift_ground(sides_.second());
  });
  frames_to_settle_ = kFramesToSettle;
  settled_ = true;
}

void Window::frame(double elapsed) {
  if (!picture_.update()) {
    input_.discard();
    stage_.pacing.restart();
    return;
  }
  log_.begin(elapsed);
  Messages& messages = stage_.messages;
  const Framebuffer& framebuffer = *stage_.framebuffer;
  Requests requests;
  const Camera view = stage_.session->camera;
  do {
    requests = {};
    if (messages.is_error() && input_.take_key(GLFW_KEY_ESCAPE)) messages.clear();  // in front of everything else
    overlay_.set_legend_font(stage_.session->display().legend.font_size);
    overlay_.begin(framebuffer.width(), framebuffer.height());
    messages.attempt([&] { controls_.handle(requests); });
    if (view.eye != stage_.session->camera.eye || view.target != stage_.session->camera.target)
      stage_.state.replay_camera = false;
    messages.attempt([&] {
      panels_.draw(requests);
      sides_.share();
      tuning_.follow();
    });
    controls_.note_panels();
    overlay_.end();
    messages.attempt([&] { carry_out(requests); });
  } while (input_.waiting() && !requests.wait_for_picture());
  log_.end_of(FrameLog::Part::panels);
  follow_kernels();
  observer_.follow_fit();
  const long steps_before = stepping_.stats().steps;
  if (shown_ && !messages.attempt([&] { simulate(elapsed, requests.step); })) stage_.state.paused = true;
  messages.attempt([&] { recording_.follow_replay(); });
  log_.end_of(FrameLog::Part::steps);
  govern(elapsed, view);
  if (!messages.attempt([&] { picture_.draw(governor_.level()); })) stage_.state.paused = true;
  log_.end_of(FrameLog::Part::scene);
  overlay_.draw(framebuffer);
  messages.attempt([&] { capture(requests); });
  messages.attempt([&] { recording_.follow(); });
  overlay_.draw_foreground(framebuffer);
  log_.end_of(FrameLog::Part::overlay);
  framebuffer.present(framebuffer.width(), framebuffer.height());
  glfwSwapBuffers(graphics_.context->window());
  log_.end_of(FrameLog::Part::present);
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  log_.end({static_cast<int>(stepping_.stats().steps - steps_before),
            shown_ ? stepping_.simulated() : 0,
            stepping_.compiled(),
            graphics_.programs->fusing(),
            0,
            {pointer.x, pointer.y}});
  shown_ = true;
}

void Window::follow_kernels() {
  stage_.messages.attempt([&] {
    kernels_.follow([&] {
      for (Session* session : {stage_.session.get(), sides_.second()})
        if (session) session->simulation.gpu()->record_again();
    });
  });
  stage_.state.statistics.compiling = kernels_.compiling();
}

// The time of a frame is that of the one before, with the picture drawn then.
void Window::govern(double elapsed, const Camera& before) {
  const Camera& now = stage_.session->camera;
  const bool moves = !stepping_.still() || stage_.mouse.dragging() || stage_.hand.dragging() || before.eye != now.eye ||
                     before.target != now.target;
  Statistics& statistics = stage_.state.statistics;
  governor_.follow(elapsed, statistics.render.latest() / 1000, moves, stepping_.compiled());
  statistics.quality = kLevelNames[static_cast<std::size_t>(governor_.level())];
}

void Window::simulate(double elapsed, bool one_step) {
  stepping_.advance(elapsed, one_step);
  recovery_.follow();
  observer_.read();
  sides_.follow_error();
}

void Window::capture(const Requests& requests) {
  capture_.follow(stepping_.simulated());
  if (requests.video) capture_.toggle_video();
  observer_.write_plots(requests);
  if (requests.fit) observer_.start_fit(std::filesystem::read_symlink("/proc/self/exe"));
  if (requests.screenshot) capture_.screenshot();
}

void Window::carry_out(const Requests& requests) {
  panels_.ask(requests);
  if (requests.resume) resume(*requests.resume);
  if (requests.resume_recovered && recovery_.left()) resume(std::filesystem::path(*recovery_.left()));
  if (requests.forget_recovered) recovery_.forget_left();
  if (requests.open) open(*requests.open);
  if (requests.save) {
    stage_.save(*requests.save, requests.save_with_mesh);
    panels_.opened(*requests.save);
  }
  if (requests.export_state) stage_.export_state(*requests.export_state);
  if (requests.save_replay) recording_.save(*requests.save_replay);
  if (requests.end_replay) recording_.take_over_replay();
  if (requests.compare != CompareAsk::nothing)
    sides_.carry_out(requests.compare, [&](const auto& change) { recording_.begin_anew_around(change); });
  if (requests.history) tuning_.go_to(*requests.history);
  if (requests.materials) tuning_.set_materials(*requests.materials);
  if (requests.fixed) tuning_.set_fixed(*requests.fixed);
  if (requests.painting) tuning_.set_painting(*requests.painting);
  if (requests.elements) tuning_.set_elements(*requests.elements);
  if (requests.rescale) rescale(*requests.rescale);
  if (requests.open_again) open_again(*requests.open_again);
  if (requests.end_fit) observer_.end_fit();
  if (requests.apply_fit) tuning_.set_values(std::exchange(stage_.state.plots.fit.found, {}));
  if (requests.copy_command) tuning_.copy_command();
  if (requests.reset) reset();
  if (requests.step) stage_.state.paused = true;
  if (requests.frame_view) picture_.frame_bodies();
  if (requests.pick_instrument) stage_.hand.pick(*requests.pick_instrument);
  if (requests.let_go_instrument) stage_.hand.pick(std::nullopt);
  if (requests.move_jaws) stage_.hand.move_jaws(*requests.move_jaws, sides_.held());
  if (requests.stop_jaws) stage_.hand.stop_jaws(sides_.held());
  if (requests.add_instrument) add_instrument(*requests.add_instrument);
  if (requests.remove_instrument) remove_instrument(*requests.remove_instrument);
  if (requests.let_go) stage_.mouse.let_go_staying(sides_.held());
  if (requests.reload_shaders) reload_shaders();
  if (requests.close) glfwSetWindowShouldClose(graphics_.context->window(), GLFW_TRUE);
}

void Window::open(const std::filesystem::path& file) {
  if (lower_ending(file) == ".csv") return observer_.show_measured(file);  // beside the open scene
  take_over(opener_.open(file));
  panels_.opened(file);
}

void Window::take_over(std::unique_ptr<Session> opened) {
  sides_.let_go();
  stage_.messages.attempt([&] { recording_.end(); });
  sides_.close();
  observer_.end_fit();
  stage_.state.convergence.forget();
  stage_.state.plots.forget();
  stage_.session = std::move(opened);
  stage_.messages.clear();
  session_began();
}

void Window::session_began() {
  shown_ = false;
  recovery_.session_began();
  stage_.state.facts = SceneFacts(stage_.simulation().scene, stage_.simulation().model);
  stage_.state.replaced_law.reset();
  stage_.state.instruments = {};
  stage_.hand.pick(std::nullopt);
  stage_.state.statistics = {};
  stage_.state.statistics.measured = true;
  tuning_.session_began();
  stage_.pacing.restart();
  stage_.diagnose = true;
  set_title();
  recording_.session_began();
  kernels_.session_began(stage_.simulation());
}

void Window::set_title() {
  const Scene& scene = stage_.simulation().scene;
  const std::string title = scene.title.empty() ? scene.file.filename().string() : scene.title;
  glfwSetWindowTitle(graphics_.context->window(), (title + " - fascia").c_str());
}

void Window::resume(const std::filesystem::path& file) {
  take_over(opener_.resume(file));
  recovery_.resumed(file);
}

void Window::rescale(double factor) {
  take_over(opener_.make(tuning_.rescaled(factor)));
  stage_.messages.say("Scaled by " + engineering(factor, "") +
                      ": the scene restarts with an empty undo history. Ctrl+S saves the scaled scene");
}

void Window::open_again(const std::vector<std::string>& overrides) {
  const std::size_t instruments = stage_.simulation().scene.tools.instruments.size();
  take_over(opener_.open(stage_.simulation().scene.file, overrides));
  const std::string lost = instruments > 0 ? " and without its " + plural(instruments, "instrument") : "";
  stage_.messages.say("The mesh was opened again, with an empty undo history" + lost + ". Ctrl+S saves it as a scene");
}

void Window::add_instrument(InstrumentPreset preset) {
  std::vector<Instrument> instruments = stage_.simulation().scene.tools.instruments;
  instruments.push_back(preset_instrument(preset, stage_.simulation()));
  tuning_.set_instruments(instruments);
  const std::size_t added = stage_.simulation().model.tools.size() - 1;
  stage_.hand.pick(added);
  picture_.show_tool(added);
}

void Window::remove_instrument(std::size_t index) {
  stage_.hand.pick(std::nullopt);
  std::vector<Instrument> instruments = stage_.simulation().scene.tools.instruments;
  instruments.erase(instruments.begin() + static_cast<std::ptrdiff_t>(index));
  tuning_.set_instruments(instruments);
}

void Window::reset() {
  sides_.let_go();
  recording_.reset_around([&] { sides_.reset(); });
  stage_.session->forget_errors();
  stage_.session->forget_ground();
  stage_.state.statistics.steps = 0;
  stage_.pacing.restart();
  stage_.diagnose = true;
}

void Window::reload_shaders() {
  std::string text;
  for (const std::string& message : graphics_.programs->reload()) text += (text.empty() ? "" : "\n") + message;
  if (text.empty())
    stage_.messages.say("Reloaded " + std::to_string(graphics_.programs->size()) + " programs");
  else
    stage_.messages.say(text + "\nThe old shaders stay in use", true);
}

}  // namespace fascia
