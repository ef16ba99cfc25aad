#include "app/video/session_recording.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <vector>

#include "app/system/user_files.h"
#include "base/error.h"
#include "base/file.h"
#include "sim/scene/scene_carry.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kSessionsKept = 10;  // sessions
constexpr auto kLongestUnwritten = std::chrono::seconds(1);

// The oldest first: their names are dates.
std::vector<fs::path> sessions_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ec;
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec))
    if (it->path().extension() == ".fascia") files.push_back(it->path());
  std::sort(files.begin(), files.end());
  return files;
}

// "20250131-235959-1234.fascia" and "...-1234-2.fascia" belong to process 1234.
bool still_recorded(const fs::path& file) {
  int process = 0;
  if (std::sscanf(file.filename().c_str(), "%*d-%*d-%d", &process) != 1 || process <= 0 || process == getpid())
    return false;
  return kill(process, 0) == 0 || errno == EPERM;
}

}  // namespace

fs::path session_file() {
  if (state_folder().empty()) return {};
  const fs::path folder = state_folder() / "sessions";
  std::error_code ec, ignored;
  fs::create_directories(folder, ec);
  if (ec) throw Error(folder.string(), "cannot be made: " + ec.message(), "expected a folder for recorded sessions");
  std::vector<fs::path> files = sessions_in(folder);
  for (std::size_t i = 0; i + kSessionsKept <= files.size(); ++i)
    if (!still_recorded(files[i])) fs::remove(files[i], ignored);
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char stamp[32];
  std::strftime(stamp, sizeof stamp, "%Y%m%d-%H%M%S", &local);
  const std::string stem = std::string(stamp) + "-" + std::to_string(getpid());
  fs::path path = folder / (stem + ".fascia");
  for (int n = 2; fs::exists(path, ec); ++n) path = folder / (stem + "-" + std::to_string(n) + ".fascia");
  return path;
}

SessionRecording::SessionRecording(fs::path path, Replay beginning)
    : path_(std::move(path)),
      beginning_(std::move(beginning)),
      out_(path_, std::ios::binary | std::ios::trunc),
      flushed_(Clock::now()) {
  beginning_.timed = true;
  out_ << replay_header(beginning_, path_.parent_path());
  out_.flush();
  if (!out_)
    throw Error(path_.string(), std::string("cannot be written: ") + std::strerror(errno),
                "expected a folder for recorded sessions");
}

SessionRecording::~SessionRecording() {
  if (used_) return;
  out_.close();
  std::error_code ignored;
  fs::remove(path_, ignored);
}

void SessionRecording::add(const Input& input) {
  if (failed_) return;
  used_ |= !std::holds_alternative<BackgroundInput>(input.change) && !std::holds_alternative<GrantInput>(input.change);
  write_look();
  out_ << replay_line(input);
  news_ = true;
}

void SessionRecording::look(long steps, const CameraSettings& camera, const DisplaySettings& display) {
  if (failed_) return;
  if (looked_camera_.value_or(steps) != steps || looked_display_.value_or(steps) != steps) write_look();
  if (!seen_ || !(camera == camera_)) looked_camera_ = steps;
  if (!seen_ || !(display == display_)) looked_display_ = steps;
  seen_ = true;
  camera_ = camera;
  display_ = display;
}

void SessionRecording::write_look() {
  if (looked_camera_) out_ << replay_line({*looked_camera_, camera_});
  if (looked_display_) out_ << replay_line({*looked_display_, display_});
  news_ |= looked_camera_ || looked_display_;
  looked_camera_.reset();
  looked_display_.reset();
}

void SessionRecording::breathe(long steps) {
  if (failed_ || Clock::now() - flushed_ < kLongestUnwritten) return;
  write_look();
  if (steps != noted_steps_) out_ << replay_steps_line(steps);
  news_ |= steps != noted_steps_;
  noted_steps_ = steps;
  flush();
}

void SessionRecording::note_state(long steps, std::uint64_t hash) {
  if (failed_) return;
  write_look();
  out_ << replay_steps_line(steps, hash);
  noted_steps_ = steps;
  news_ = true;
  flush();
}

void SessionRecording::flush() {
  flushed_ = Clock::now();
  if (!news_) return;
  news_ = false;
  errno = 0;
  out_.flush();
  if (out_) return;
  failed_ = true;
  throw Error(path_.string(), std::string("the session is no longer recorded: ") + std::strerror(errno),
              "expected free disk space");
}

bool SessionRecording::carry_files(std::vector<ReadFile>& read) {
  const auto carried = [&] {
    const std::vector<KnownFile>& files = beginning_.scene.files;
    return !files.empty() &&
           std::all_of(files.begin(), files.end(), [](const KnownFile& file) { return file.deflated != nullptr; });
  };
  if (!carried()) beginning_.scene = self_contained_if_possible(std::move(beginning_.scene), read);
  return carried();
}

void SessionRecording::save_as(const fs::path& path) {
  if (failed_) throw Error(path_.string(), "the session is recorded in part only", "expected enough free disk space");
  std::error_code ec;
  if (fs::equivalent(path, path_, ec))
    throw Error(path.string(), "is where the session is being recorded", "expected another file");
  const std::string recorded = read_file(path_);
  write_file(path, replay_header(beginning_, path.parent_path()) +
                       recorded.substr(std::min(recorded.find('\n') + 1, recorded.size())));
}

}  // namespace fascia
