#include "app/window/parts/autosave.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

#include "base/file.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

constexpr auto kPause = std::chrono::seconds(5);  // between two writes
constexpr double kMostShare = 0.02;               // of the time of one CPU core
constexpr auto kForgotten = std::chrono::hours(24 * 14);
constexpr const char* kLast = ".last";  // replaces the process

// Start time of a process in clock ticks since boot: with the process id it identifies a process uniquely. Empty
// without such a process.
std::string start_of(const std::string& process) {
  std::ifstream in("/proc/" + process + "/stat");
  std::string line, field;
  if (!std::getline(in, line)) return "";
  std::istringstream fields(
      line.substr(std::min(line.size(), line.rfind(')') + 1)));  // the name before may contain any character
  fields >> field;
  if (field == "Z") return "";  // ended, but not yet reaped by its parent
  for (int i = 4; i <= 22; ++i) fields >> field;
  return field;
}

// "liver.1234-5678.fascia": scene, process, its start.
struct Owner {
  std::string process, start;
};
std::optional<Owner> owner_of(const fs::path& file) {
  const std::string owner = file.stem().extension().string();
  const std::size_t dash = owner.find('-');
  if (file.extension() != ".fascia" || dash == std::string::npos) return std::nullopt;
  return Owner{owner.substr(1, dash - 1), owner.substr(dash + 1)};
}

}  // namespace

Autosave::Autosave(fs::path folder) : folder_(std::move(folder)) {}

Autosave::~Autosave() {
  if (writing_.valid()) writing_.wait();
}

bool Autosave::due() const {
  const bool busy = writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  return !busy && Clock::now() >= next_;
}

void Autosave::wait_a_while() { next_ = Clock::now() + kPause; }

void Autosave::keep(std::shared_ptr<const Replay> replay, const std::string& name) {
  if (folder_.empty()) return;
  if (writing_.valid()) {
    try {
      const std::chrono::duration<double> took = writing_.get();
      next_ += std::chrono::duration_cast<Clock::duration>(took / kMostShare);
    } catch (...) {
      folder_.clear();
      throw;
    }
  }
  const std::string process = std::to_string(getpid());
  std::string stem = name;
  std::replace(stem.begin(), stem.end(), '.', '_');
  const fs::path before = std::exchange(file_, folder_ / (stem + "." + process + "-" + start_of(process) + ".fascia"));
  if (!before.empty() && before != file_) outdated_.push_back(before);  // of the previous scene
  writing_ = std::async(std::launch::async,
                        [replay = std::move(replay), file = file_, outdated = std::exchange(outdated_, {})] {
                          const Clock::time_point start = Clock::now();
                          fs::create_directories(file.parent_path());
                          write_replay(file, *replay);
                          std::error_code ec;
                          for (const fs::path& old : outdated) fs::remove(old, ec);
                          return std::chrono::duration<double>(Clock::now() - start);
                        });
}

void Autosave::finish() {
  if (writing_.valid()) writing_.wait();
  if (file_.empty()) return;
  std::error_code ec;
  const fs::path old = last(), now = folder_ / (name_in(file_) + kLast + ".fascia");
  fs::rename(file_, now, ec);
  if (!ec && !old.empty() && old != now) fs::remove(old, ec);
  file_.clear();
}

std::optional<fs::path> Autosave::left_behind() const {
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  std::error_code ec;
  for (fs::directory_iterator it(folder_, ec), end; !ec && it != end; it.increment(ec)) {
    const std::optional<Owner> owner = owner_of(it->path());
    if (!owner || start_of(owner->process) == owner->start) continue;  // not an autosave, or its window is still open
    std::error_code unreadable;
    const fs::file_time_type written = it->last_write_time(unreadable);
    if (!unreadable) found.emplace_back(written, it->path());
  }
  std::sort(found.rbegin(), found.rend());
  for (const auto& [written, file] : found)
    if (file != found.front().second && fs::file_time_type::clock::now() - written > kForgotten) fs::remove(file, ec);
  return found.empty() ? std::nullopt : std::optional(found.front().second);
}

fs::path Autosave::last() const {
  std::error_code ec;
  for (fs::directory_iterator it(folder_, ec), end; !ec && it != end; it.increment(ec))
    if (it->path().extension() == ".fascia" && it->path().stem().extension() == kLast) return it->path();
  return {};
}

std::string Autosave::name_in(const fs::path& file) { return file.stem().stem().string(); }

}  // namespace fascia
