#include "base/file.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

#include "base/error.h"

namespace fascia {
namespace fs = std::filesystem;

namespace {

constexpr const char* writable = "expected a writable folder with free space";

std::string reason(int error_number) { return error_number ? std::string(": ") + std::strerror(error_number) : ""; }

/// Runs the writer and checks that every byte was written. Returns an empty text or the reason of a failure.
std::string write_stream(const fs::path& path, const std::function<void(std::ostream&)>& writer) {
  errno = 0;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  if (!out) return "cannot be written" + reason(errno);
  errno = 0;
  writer(out);
  out.flush();
  if (!out) return "writing failed" + reason(errno);
  out.close();
  if (!out) return "writing failed" + reason(errno);
  return "";
}

/// The data must be on disk before the name: a power failure must not leave an empty file under the final name.
std::string sync(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return "";
  const int error_number = fsync(descriptor) == 0 || errno == EINVAL ? 0 : errno;
  close(descriptor);
  return error_number ? "writing failed" + reason(error_number) : "";
}

std::string temporary_prefix(const fs::path& path) { return "." + path.stem().string() + "."; }

/// Removes files ".stem.PID-NUMBER.part*" of processes that have ended. A file whose PID another process has reused
/// stays.
void remove_stale(const fs::path& target) {
  const std::string prefix = temporary_prefix(target);
  std::error_code ec;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  for (fs::directory_iterator entry(folder, ec), end; !ec && entry != end; entry.increment(ec)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(prefix)) continue;
    const char* const last = name.data() + name.size();
    pid_t process = 0;
    unsigned number = 0;
    const auto after_process = std::from_chars(name.data() + prefix.size(), last, process);
    if (after_process.ec != std::errc{} || process <= 0 || after_process.ptr == last || *after_process.ptr != '-')
      continue;
    const auto after_number = std::from_chars(after_process.ptr + 1, last, number);
    if (after_number.ec != std::errc{} || !std::string_view(after_number.ptr, last).starts_with(".part")) continue;
    std::error_code ignored;
    if (kill(process, 0) != 0 && errno == ESRCH) fs::remove(entry->path(), ignored);
  }
}

bool is_special(const fs::file_status& status) { return fs::exists(status) && !fs::is_regular_file(status); }

void write_standard_output(const std::function<void(std::ostream&)>& writer) {
  errno = 0;
  writer(std::cout);
  if (!std::cout.flush())
    throw Error("standard output", "writing failed" + reason(errno), "expected a device that takes data");
}

}  // namespace

const std::string& read_standard_input() {
  static const std::string content{std::istreambuf_iterator<char>(std::cin), {}};
  return content;
}

fs::path link_target(const fs::path& path) {
  constexpr int kMostLinks = 40;  // the limit of Linux
  fs::path target = path;
  std::error_code ec;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, ec)); ++links) {
    if (links == kMostLinks)
      throw Error(path.string(), "is a symbolic link that leads in a circle", "expected a file name");
    const fs::path next = fs::read_symlink(target, ec);
    if (ec)
      throw Error(path.string(), "is a symbolic link that cannot be read: " + ec.message(), "expected a file name");
    target = target.parent_path() / next;  // an absolute path replaces the folder
  }
  return target;
}

fs::path temporary_name(const fs::path& path) {
  static std::atomic<unsigned> calls{0};  // threads may write the same target
  const fs::path target = link_target(path);
  fs::path name = target.parent_path() /
                  (temporary_prefix(target) + std::to_string(getpid()) + "-" + std::to_string(++calls) + ".part");
  name += path.extension();
  return name;
}

void replace_file(const fs::path& temporary, const fs::path& path) {
  std::error_code ec, ignored;
  const fs::path target = link_target(path);
  fs::rename(temporary, target, ec);
  if (ec) {
    fs::remove(temporary, ignored);
    throw Error(path.string(), "cannot be replaced: " + ec.message(), writable);
  }
  remove_stale(target);
}

std::string lower_ending(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

void require_writable(const fs::path& path) {
  if (path == kStandardOutput) return;
  std::error_code ec;
  const fs::file_status status = fs::status(path, ec);
  if (fs::is_directory(status)) throw Error(path.string(), "is a directory", "expected a file name");
  if (is_special(status)) return;
  const fs::path target = link_target(path), folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ec)) {
    const std::string link = target == path ? "" : "links to " + target.string() + ": ";
    throw Error(path.string(), link + "no such folder " + folder.string(), "expected an existing folder");
  }
  // A rename would also replace a read-only file, which its permissions protect.
  if (fs::exists(status) && access(path.c_str(), W_OK) != 0) {
    throw Error(path.string(), "cannot be written" + reason(errno), "expected a file that may be changed");
  }
  errno = 0;
  if (!fs::exists(status) && access(folder.c_str(), W_OK) != 0) {
    throw Error(path.string(), "cannot be written" + reason(errno), writable);
  }
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& writer) {
  if (path == kStandardOutput) return write_standard_output(writer);
  require_writable(path);
  std::error_code ec;
  const fs::file_status status = fs::status(path, ec);
  if (is_special(status)) {
    if (const std::string problem = write_stream(path, writer); !problem.empty()) {
      throw Error(path.string(), problem, "expected a device that takes data");
    }
    return;
  }

  const fs::path temporary = temporary_name(path);
  std::string problem;
  try {
    problem = write_stream(temporary, writer);
    if (problem.empty()) problem = sync(temporary);
  } catch (...) {
    fs::remove(temporary, ec);
    throw;
  }
  if (!problem.empty()) {
    fs::remove(temporary, ec);
    throw Error(path.string(), problem, writable);
  }
  if (fs::exists(status)) fs::permissions(temporary, status.permissions(), ec);
  replace_file(temporary, path);
}

void write_file(const fs::path& path, std::string_view content) {
  write_file(path, [&](std::ostream& out) { out.write(content.data(), static_cast<std::streamsize>(content.size())); });
}

}  // namespace fascia
