#include "sim/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include "sim/error.h"

namespace fascia {
namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
  std::error_code ec;
  const fs::file_status status = fs::status(path, ec);
  if (!fs::exists(status)) throw Error(path.string(), "no such file", "expected a readable file");
  if (fs::is_directory(status)) throw Error(path.string(), "is a directory", "expected a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(path.string(), std::string("cannot be opened: ") + std::strerror(errno), "expected a readable file");
  std::string content;
  const auto size = fs::file_size(path, ec);  // pipes and devices have none
  if (!ec) content.reserve(size);
  char block[1 << 16];
  while (in.read(block, sizeof block) || in.gcount() > 0) content.append(block, static_cast<std::size_t>(in.gcount()));
  if (in.bad()) throw Error(path.string(), "reading failed", "expected a readable file");
  return content;
}

fs::path temporary_name(const fs::path& path) {
  fs::path name = path.parent_path() / ("." + path.stem().string() + "." + std::to_string(getpid()) + ".part");
  name += path.extension();
  return name;
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& writer) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code ec;
  if (!fs::is_directory(folder, ec)) throw Error(path.string(), "no such folder " + folder.string(), "expected an existing folder");
  if (fs::is_directory(path, ec)) throw Error(path.string(), "is a directory", "expected a file name");
  const fs::path temporary = temporary_name(path);
  const auto fail = [&](const std::string& what) {
    const int why = errno;
    fs::remove(temporary, ec);
    throw Error(path.string(), what + (why ? std::string(": ") + std::strerror(why) : ""),
                "expected a writable folder with free space");
  };
  errno = 0;
  std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
  if (!out) fail("cannot be written");
  try {
    writer(out);
  } catch (...) {
    out.close();
    fs::remove(temporary, ec);
    throw;
  }
  out.flush();
  if (!out) fail("writing failed");
  out.close();
  if (!out) fail("writing failed");
  // The data must be on disk before the name is: a power cut must not leave an empty file under the final name.
  if (const int descriptor = open(temporary.c_str(), O_RDONLY); descriptor >= 0) {
    const bool synced = fsync(descriptor) == 0 || errno == EINVAL;
    close(descriptor);
    if (!synced) fail("writing failed");
  }
  errno = 0;
  fs::rename(temporary, path, ec);
  if (ec) {
    errno = ec.value();
    fail("cannot be replaced");
  }
}

void write_file(const fs::path& path, std::string_view content) {
  write_file(path, [&](std::ostream& out) { out.write(content.data(), static_cast<std::streamsize>(content.size())); });
}

}  // namespace fascia
