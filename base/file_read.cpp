// Reads whole files, and refuses input that is none: pipes without a writer, files without data, files larger than the
// memory.
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <mutex>
#include <system_error>

#include "base/error.h"
#include "base/file.h"

namespace fascia {
namespace fs = std::filesystem;

namespace {

constexpr const char* kReadable = "expected a readable file";
constexpr std::uint64_t kSmallHole = 16 << 20;         // [bytes] of zeros that are read without an error
constexpr std::size_t kReadBlock = 1 << 20;            // [bytes] between progress reports
constexpr auto kWriterWait = std::chrono::seconds(5);  // for a first writer to open a pipe
constexpr int kPollInterval = 100;                     // [ms]

std::string bytes_text(std::uint64_t bytes) {
  char text[32];
  if (bytes < 100000)
    std::snprintf(text, sizeof text, "%llu bytes", static_cast<unsigned long long>(bytes));
  else if (bytes < 100000000)
    std::snprintf(text, sizeof text, "%.1f MB", static_cast<double>(bytes) / 1e6);
  else
    std::snprintf(text, sizeof text, "%.1f GB", static_cast<double>(bytes) / 1e9);
  return text;
}

/// Memory that the kernel can provide without swapping, or the rest of the process's own limit (ulimit -v) [bytes].
std::uint64_t free_memory() {
  std::uint64_t free = std::numeric_limits<std::uint64_t>::max(), number = 0;
  std::ifstream system("/proc/meminfo");
  for (std::string word; system >> word;) {
    if (word == "MemAvailable:" && system >> number) free = number * 1024;
  }
  rlimit limit{};
  std::ifstream process("/proc/self/statm");
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY && process >> number) {
    const std::uint64_t used = number * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    free = std::min<std::uint64_t>(free, limit.rlim_cur > used ? limit.rlim_cur - used : 0);
  }
  return free;
}

class OpenFile {
 public:
  OpenFile(const fs::path& path, int flags)
      : path_(path), descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | flags)) {
    if (descriptor_ < 0)
      throw Error(path.string(), std::string("cannot be opened: ") + std::strerror(errno), kReadable);
  }
  ~OpenFile() { close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  std::uint64_t size() const {
    struct stat status {};
    return fstat(descriptor_, &status) == 0 && status.st_size > 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
  }

  /// Number of bytes that are stored; the others are holes, which read as zeros.
  std::uint64_t stored(std::uint64_t size) const {
    std::uint64_t stored = 0;
    const auto end = static_cast<off_t>(size);
    for (off_t at = 0; at < end;) {
      const off_t data = lseek(descriptor_, at, SEEK_DATA);
      if (data < 0 && errno == ENXIO) break;
      const off_t hole = data < 0 ? -1 : lseek(descriptor_, data, SEEK_HOLE);
      if (hole <= data) {  // a file system without holes
        stored = size;
        break;
      }
      stored += static_cast<std::uint64_t>(hole - data);
      at = hole;
    }
    lseek(descriptor_, 0, SEEK_SET);
    return stored;
  }

  /// Appends the available data, at most a block. Returns its size, 0 at the end, or -1 if a pipe has no data yet.
  ssize_t append_to(std::string& content) {
    const std::size_t before = content.size();
    content.resize(before + kReadBlock);
    ssize_t count = 0;
    do count = read(descriptor_, content.data() + before, kReadBlock);
    while (count < 0 && errno == EINTR);
    const int error_number = errno;
    content.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count < 0 && error_number != EAGAIN)
      throw Error(path_.string(), std::string("reading failed: ") + std::strerror(error_number), kReadable);
    return count;
  }

  /// Waits briefly for data. True if there was a writer that has closed the pipe.
  bool wait() const {
    pollfd state{descriptor_, POLLIN, 0};
    const bool gone =
        poll(&state, 1, kPollInterval) > 0 && (state.revents & POLLHUP) != 0 && (state.revents & POLLIN) == 0;
    return gone;
  }

 private:
  const fs::path& path_;
  int descriptor_;
};

void require_memory(const fs::path& path, std::uint64_t size) {
  if (const std::uint64_t free = free_memory(); size > free)
    throw Error(path.string(), "needs more than " + bytes_text(size) + " of memory, " + bytes_text(free) + " are free",
                "expected a smaller file");
}

std::string read_regular(const fs::path& path, const Progress& progress) {
  OpenFile file(path, 0);
  const std::uint64_t size = file.size();
  require_memory(path, size);
  if (size > kSmallHole) {
    // An interrupted download or copy, or a file preallocated for its size: reading its zeros is useless.
    if (const std::uint64_t stored = file.stored(size); size - stored > std::max(kSmallHole, stored))
      throw Error(path.string(),
                  "is " + bytes_text(size) + " long, but only " + bytes_text(stored) +
                      " of them are stored, the rest is a hole",
                  "expected a complete file");
  }
  std::string content;
  content.reserve(size + kReadBlock);
  while (file.append_to(content) > 0) {
    if (size > 0)
      report(progress, std::min(1.0, static_cast<double>(content.size()) / static_cast<double>(size)), "Reading");
  }
  return content;
}

std::string read_pipe_once(const fs::path& path, const Progress& progress) {
  OpenFile file(path, O_NONBLOCK);  // otherwise opening waits for a writer, possibly forever
  std::string content;
  bool has_writer = false;
  std::size_t next_check = kReadBlock;
  const auto start = std::chrono::steady_clock::now();
  for (;;) {
    const ssize_t count = file.append_to(content);
    if (count == 0 && has_writer) return content;
    has_writer |= count != 0;
    report(progress, 0, "Reading a pipe");
    if (content.size() >= next_check) {
      require_memory(path, content.size());  // the same amount again: the size of a pipe is unknown
      next_check = 2 * content.size();
    }
    if (count > 0) continue;
    if (file.wait() && !has_writer) return content;
    if (!has_writer && std::chrono::steady_clock::now() - start > kWriterWait)
      throw Error(path.string(),
                  "is a pipe into which nothing writes; waited " + std::to_string(kWriterWait.count()) + " s",
                  "expected a program that writes into it");
  }
}

/// A pipe provides its bytes once, but files are read more than once: to detect their kind, for a report, for the
/// model.
std::string read_pipe(const fs::path& path, const Progress& progress) {
  static std::mutex mutex;
  static std::map<fs::path, std::string> contents;
  const std::lock_guard lock(mutex);
  auto content = contents.find(path);
  if (content == contents.end()) content = contents.emplace(path, read_pipe_once(path, progress)).first;
  return content->second;
}

}  // namespace

std::string read_file(const fs::path& path, const Progress& progress) {
  std::error_code ec;
  const fs::file_status status = fs::status(path, ec);
  if (status.type() == fs::file_type::none) throw Error(path.string(), "cannot be opened: " + ec.message(), kReadable);
  if (!fs::exists(status)) throw Error(path.string(), "no such file", kReadable);
  if (fs::is_directory(status)) throw Error(path.string(), "is a directory", "expected a file");
  if (fs::is_fifo(status)) return read_pipe(path, progress);
  if (!fs::is_regular_file(status))
    throw Error(path.string(), "is a device", "expected a file");  // /dev/zero never ends
  return read_regular(path, progress);
}

}  // namespace fascia
