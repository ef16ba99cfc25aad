#include "sim/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "sim/error.h"

namespace fascia {
namespace fs = std::filesystem;

namespace {

constexpr const char* writable = "expected a writable folder with free space";

std::string reason(int error_number) {
  return error_number ? std::string(": ") + std::strerror(error_number) : "";
}

/// Runs the writer and makes sure that every byte has left this process. Returns an empty text or what went
/// wrong.
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

/// The data must be on disk before the name is: a power cut must not leave an empty file under the final
/// name.
std::string sync(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return "";
  const int error_number = fsync(descriptor) == 0 || errno == EINVAL ? 0 : errno;
  close(descriptor);
  return error_number ? "writing failed" + reason(error_number) : "";
}

}  // namespace

std::string read_file(const fs::path& path) {
  std::error_code ec;
  const fs::file_status status = fs::status(path, ec);
  if (status.type() == fs::file_type::none)
    throw Error(path.string(), "cannot be opened: " + ec.message(), "expected a readable file");
  if (!fs::exists(status)) throw Error(path.string(), "no such file", "expected a readable file");
  if (fs::is_directory(status)) throw Error(path.string(), "is a directory", "expected a file");
  if (!fs::is_regular_file(status) && !fs::is_fifo(status)) {
    throw Error(path.string(), "is a device", "expected a file");  // /dev/zero never ends
  }
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(path.string(), "cannot be opened" + reason(errno), "expected a readable file");
  std::string content;
  const auto size = fs::file_size(path, ec);  // pipes have none
  if (!ec) content.reserve(size);
  char block[1 << 16];
  while (in.read(block, sizeof block) || in.gcount() > 0)
    content.append(block, static_cast<std::size_t>(in.gcount()));
  if (in.bad()) throw Error(path.string(), "reading failed", "expected a readable file");
  return content;
}

fs::path temporary_name(const fs::path& path) {
  fs::path name =
      path.parent_path() / ("." + path.stem().string() + "." + std::to_string(getpid()) + ".part");
  name += path.extension();
  return name;
}

std::string lower_ending(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending;
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& writer) {
  std::error_code ec;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ec)) {
    throw Error(path.string(), "no such folder " + folder.string(), "expected an existing folder");
  }
  const fs::file_status status = fs::status(path, ec);
  if (fs::is_directory(status)) throw Error(path.string(), "is a directory", "expected a file name");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    if (const std::string problem = write_stream(path, writer); !problem.empty()) {
      throw Error(path.string(), problem, "expected a device that takes data");
    }
    return;
  }

  const fs::path target = fs::is_symlink(path, ec) ? fs::weakly_canonical(path, ec) : path;
  const fs::path temporary = temporary_name(target);
  std::string problem;
  try {
    problem = write_stream(temporary, writer);
    if (problem.empty()) problem = sync(temporary);
  } catch (...) {
    fs::remove(temporary, ec);
    throw;
  }
  if (problem.empty()) {
    fs::rename(temporary, target, ec);
    if (ec) problem = "cannot be replaced: " + ec.message();
  }
  if (!problem.empty()) {
    fs::remove(temporary, ec);
    throw Error(path.string(), problem, writable);
  }
}

void write_file(const fs::path& path, std::string_view content) {
  write_file(path, [&](std::ostream& out) {
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
  });
}

}  // namespace fascia
