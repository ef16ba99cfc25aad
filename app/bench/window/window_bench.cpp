#include "app/bench/window/window_bench.h"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <thread>

#include "app/bench/window/frames.h"
#include "app/bench/window/virtual_screen.h"
#include "app/system/user_settings.h"
#include "base/error.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

using Clock = VirtualScreen::Clock;

struct Durations {  // [s]
  double before_grab, dragged;
};
// Of a window before the warm ones: until it has seen that its kernels are compiled, or until another process has
// compiled them for a build without the command.
constexpr double kUntilSeen = 6, kUntilCompiled = 45;
constexpr double kMostToBegin = 60, kMostToEnd = 30;
constexpr auto kBetweenPuts = std::chrono::milliseconds(50);

double seconds_of(Clock::time_point time) { return std::chrono::duration<double>(time.time_since_epoch()).count(); }

// Temporary home folders of a program: its settings, and the kernels of its driver.
struct Home {
  fs::path folder;
  explicit Home(const std::string& name)
      : folder(fs::temp_directory_path() / ("fascia-window-" + std::to_string(getpid()) + "-" + name)) {
    fs::remove_all(folder);
    fs::create_directories(folder / "config" / "fascia");
    UserSettings settings;
    settings.first_run_done = true;
    write_user_settings(folder / "config" / "fascia" / "settings.json", settings);
  }
  ~Home() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  Home(const Home&) = delete;
  Home& operator=(const Home&) = delete;

  void forget_kernels() const { fs::remove_all(folder / "kernels"); }
  std::map<std::string, std::string> kernels() const {
    return {{"MESA_SHADER_CACHE_DIR", (folder / "kernels").string()}};
  }
  std::map<std::string, std::string> environment(const VirtualScreen& screen) const {
    std::map<std::string, std::string> all = kernels();
    all.insert({{"DISPLAY", screen.name()},
                {"WAYLAND_DISPLAY", ""},
                {"XDG_CONFIG_HOME", (folder / "config").string()},
                {"XDG_STATE_HOME", (folder / "state").string()}});
    return all;
  }
};

struct Subject {
  std::string name;     // in the table
  std::string program;  // path
  std::unique_ptr<Home> home;
};

// One that computes as long as it exists.
std::vector<SpawnedProgram> busy_programs(int count) {
  std::vector<SpawnedProgram> programs;
  for (int i = 0; i < count; ++i) programs.emplace_back(std::vector<std::string>{"sh", "-c", "while :; do :; done"});
  return programs;
}

void require_frame_log(const std::string& program) {
  SpawnedProgram asked({"sh", "-c", "\"$0\" view --help | grep -q -e --frame-log", program});
  const auto end = asked.wait_for_end(kMostToBegin);
  if (!end || !end->succeeded)
    throw Error(program, "is not a fascia with the option --frame-log", "expected a build that measures its frames");
}

// Fills the cache of a subject's driver with the kernels of the default scene. False if the build has no such command.
bool compile_kernels(const Bench& bench, const Subject& subject) {
  SpawnedProgram kernels({subject.program, "kernels", "--context", "egl", "--quiet"}, subject.home->kernels());
  while (!kernels.ended()) {
    bench.stop_if_interrupted();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return kernels.ended()->succeeded;
}

// The tissue is grabbed at the middle of the picture beside the panels and dragged in a circle.
WindowSession run_session(const Bench& bench, const WindowBenchOptions& options, const Subject& subject,
                          const Durations& durations, int busy) {
  const fs::path log = subject.home->folder / "frames.csv";
  fs::remove(log);
  VirtualScreen screen(options.width, options.height);
  const std::vector<SpawnedProgram> others = busy_programs(busy);
  WindowSession session;
  session.started = seconds_of(Clock::now());
  const std::string size = std::to_string(options.width) + "x" + std::to_string(options.height);
  const std::vector<std::string> command{subject.program,          "--frame-log", log.string(), "--size", size, "--set",
                                         "display.color=von_mises"};
  SpawnedProgram window(command, subject.home->environment(screen));
  const auto wait = [&](double seconds) {
    for (const auto end = Clock::now() + std::chrono::duration<double>(seconds); Clock::now() < end;
         std::this_thread::sleep_for(std::chrono::milliseconds(20))) {
      bench.stop_if_interrupted();
      if (window.ended()) throw Error(subject.program, "has ended by itself", "expected a window that stays open");
    }
  };
  SpawnedProgram seen({"xdotool", "search", "--sync", "--onlyvisible", "--class", "fascia"},
                      {{"DISPLAY", screen.name()}});
  for (const auto last = Clock::now() + std::chrono::duration<double>(kMostToBegin); !seen.ended(); wait(0.05))
    if (Clock::now() > last) throw Error(subject.program, "shows no window", "expected one within a minute");
  wait(durations.before_grab);
  const int x = static_cast<int>(0.6 * options.width), y = static_cast<int>(0.46 * options.height);
  const int radius = options.height / 12;
  screen.move(x, y);
  wait(0.3);
  session.pressed = seconds_of(screen.press());
  const int puts = static_cast<int>(durations.dragged / std::chrono::duration<double>(kBetweenPuts).count());
  for (int k = 1; k <= puts; ++k) {
    const double angle = 2 * std::numbers::pi * k / 40;
    const int to_x = x + static_cast<int>(radius * std::sin(angle)),
              to_y = y - static_cast<int>(radius * (1 - std::cos(angle)));
    session.puts.push_back({seconds_of(screen.move(to_x, to_y)), double(to_x), double(to_y)});
    wait(std::chrono::duration<double>(kBetweenPuts).count());
  }
  session.released = seconds_of(screen.release());
  wait(0.5);
  window.ask_to_end();
  if (!window.wait_for_end(kMostToEnd)) throw Error(subject.program, "does not end", "expected an end on SIGTERM");
  session.frames = read_frame_log(log);
  return session;
}

std::vector<Cell> row_of(const WindowFigures& f, const Subject& subject, int busy, const std::string& kernels) {
  const auto part = [&](const char* name) { return Cell(f.parts_ms.at(name)); };
  return {subject.name,
          busy,
          kernels,
          f.first_picture_s,
          f.longest_before_ms,
          f.longest_grabbed_ms,
          f.fused_s < 0 ? Cell("never") : Cell(f.fused_s),
          f.share,
          f.pictures_per_s,
          f.frame_ms.median,
          f.frame_ms.high,
          f.latency_ms.median,
          f.latency_ms.high,
          f.steps_per_frame,
          f.step_ms,
          part("panels_ms"),
          part("steps_ms"),
          part("scene_ms"),
          part("overlay_ms"),
          part("present_ms")};
}

}  // namespace

void bench_window(Bench& bench, const WindowBenchOptions& options) {
  const Durations durations = bench.full_or_quick(Durations{2, 6}, Durations{1, 4});
  std::vector<Subject> subjects;
  subjects.push_back({"this", fs::read_symlink("/proc/self/exe").string(), std::make_unique<Home>("this")});
  if (!options.against.empty()) {
    require_frame_log(options.against);
    subjects.push_back({"against", fs::absolute(options.against).string(), std::make_unique<Home>("against")});
  }
  Table table;
  table.notes = {"the default scene with a heat map on a virtual screen of " + std::to_string(options.width) + " x " +
                     std::to_string(options.height) + ", its tissue dragged for " + Cell(durations.dragged).text() +
                     " s",
                 "busy: programs beside it that compute without end; cold: no kernel is in the driver's cache"};
  table.columns = {"program",
                   "busy",
                   "kernels",
                   "first_picture_s",
                   "longest_before_grab_ms",
                   "longest_grabbed_ms",
                   "fused_after_s",
                   "share_of_real_time",
                   "pictures_per_s",
                   "frame_ms",
                   "frame_ms_high",
                   "latency_ms",
                   "latency_ms_high",
                   "steps_per_frame",
                   "step_ms",
                   "panels_ms",
                   "steps_ms",
                   "scene_ms",
                   "overlay_ms",
                   "present_ms"};
  const auto measure = [&](const Subject& subject, int busy, const std::string& kernels) {
    const WindowFigures f = figures_of(run_session(bench, options, subject, durations, busy));
    table.rows.push_back(row_of(f, subject, busy, kernels));
    bench.say("window: " + subject.name + ", " + kernels + ", " + std::to_string(busy) +
              " busy: " + std::to_string(std::lround(100 * f.share)) + " % of real time, " +
              std::to_string(std::lround(f.pictures_per_s)) + " pictures a second, first after " +
              Cell(f.first_picture_s).text() + " s, longest frame " +
              std::to_string(std::lround(std::max(f.longest_before_ms, f.longest_grabbed_ms))) + " ms");
    bench.write("window", table);
  };
  const std::vector<int> loads =
      !options.busy.empty() ? options.busy : bench.full_or_quick(std::vector{0, 1, 2, 4}, std::vector{0});
  const int rounds = bench.full_or_quick(3, 1);
  for (int round = 0; round < rounds; ++round)
    for (const Subject& subject : subjects) {
      subject.home->forget_kernels();
      measure(subject, 0, "cold");
    }
  for (const Subject& subject : subjects) {
    bench.say("window: " + subject.name + ", compiles its kernels");
    const bool compiled = compile_kernels(bench, subject);
    run_session(bench, options, subject, {compiled ? kUntilSeen : kUntilCompiled, durations.dragged}, 0);
  }
  for (int round = 0; round < rounds; ++round)
    for (const int busy : loads)
      for (const Subject& subject : subjects) measure(subject, busy, "warm");
}

}  // namespace fascia
