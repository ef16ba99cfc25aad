#include "app/window/parts/scene_opener.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "app/window/parts/autosave.h"
#include "base/interrupt.h"
#include "sim/contact/first_state.h"
#include "sim/scene/scene_write.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

constexpr double kReadShare = 0.4;  // share of opening a large scene before the GPU is needed

}  // namespace

std::unique_ptr<Session> SceneOpener::open(const fs::path& path, const std::vector<std::string>& sets) {
  OpeningScreen screen(graphics_, overlay_, path.filename().string());
  Opened input = read(path, sets, screen);
  return make(input, screen, kReadShare);
}

std::unique_ptr<Session> SceneOpener::resume(const fs::path& path) {
  OpeningScreen screen(graphics_, overlay_, Autosave::name_in(path));
  Opened input = read(path, {}, screen);
  const State state = input.replay && input.replay->start ? *input.replay->start : first_state(input.model);
  input.replay.reset();
  move_scene(input.scene, fs::current_path() / (Autosave::name_in(path) + ".json"));  // the name that saving suggests
  std::unique_ptr<Session> session = make(input, screen, kReadShare);
  session->simulation.go_on_from(state);
  return session;
}

std::unique_ptr<Session> SceneOpener::make(Opened opened) {
  OpeningScreen screen(graphics_, overlay_, opened.scene.file.filename().string());
  return make(opened, screen, 0);
}

// Another thread reads, so that the window stays responsive. After a cancellation the thread ends at its next report.
Opened SceneOpener::read(const fs::path& path, const std::vector<std::string>& sets, OpeningScreen& screen) {
  using Clock = std::chrono::steady_clock;
  constexpr auto kFrame = std::chrono::milliseconds(30);
  std::erase_if(given_up_, [](const std::future<Opened>& f) {
    return f.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
  struct Report {
    std::atomic<bool> given_up{false};
    std::atomic<double> share{0};
    std::atomic<const char*> what{nullptr};
  };
  const auto report = std::make_shared<Report>();
  const Progress progress = [report, name = path.filename().string()](double share, const char* what) {
    if (report->given_up) throw Cancelled{name};
    report->share = share;
    report->what = what;
  };
  std::future<Opened> reading =
      std::async(std::launch::async, [path, sets, progress] { return open_file(path, sets, progress); });
  const Clock::time_point start = Clock::now();
  while (reading.wait_for(kFrame) != std::future_status::ready) {
    // The time of parsing is unknown, so the bar advances ever more slowly.
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count(),
                 guess = 1 - std::exp(-0.3 * seconds);
    const char* const what = report->what;
    try {
      if (interrupted()) throw Cancelled{path.filename().string()};
      screen.show(kReadShare * std::max(0.5 * guess, report->share.load()),
                  (std::string(what ? what : "Reading") + "; Escape goes back").c_str());
    } catch (const Cancelled&) {
      report->given_up = true;
      given_up_.push_back(std::move(reading));
      throw;
    }
  }
  return reading.get();
}

std::unique_ptr<Session> SceneOpener::make(Opened& opened, OpeningScreen& screen, double share_done) {
  const Progress progress = [&](double share, const char* what) {
    screen.show(share_done + (1 - share_done) * share, what);
  };
  std::unique_ptr<Session> session = kernels_.make(opened.scene, [&] {
    return std::make_unique<Session>(graphics_, std::move(opened.scene), std::move(opened.model), reference_, progress);
  });
  if (opened.replay) session->simulation.play(std::move(*opened.replay));
  return session;
}

}  // namespace fascia
