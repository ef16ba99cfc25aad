#include "app/kernels/kernel_record.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <vector>

#include "base/byte_hash.h"
#include "base/file.h"
#include "sim/scene/scene_write.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostScenes = 200;

// Of Mesa, by its own rules.
fs::path driver_cache() {
  if (const char* folder = std::getenv("MESA_SHADER_CACHE_DIR")) return fs::path(folder) / "mesa_shader_cache";
  if (const char* folder = std::getenv("XDG_CACHE_HOME")) return fs::path(folder) / "mesa_shader_cache";
  const char* home = std::getenv("HOME");
  return home ? fs::path(home) / ".cache" / "mesa_shader_cache" : fs::path();
}

// Differs after the folder was removed and made again. Empty if there is none.
std::string identity_of(const fs::path& path) {
  struct statx found {};
  if (path.empty() || statx(AT_FDCWD, path.c_str(), 0, STATX_INO | STATX_BTIME, &found) != 0) return "";
  std::ostringstream text;
  text << found.stx_ino << ' ' << found.stx_btime.tv_sec << '.' << found.stx_btime.tv_nsec;
  return text.str();
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::vector<std::string> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

KernelRecord::KernelRecord(fs::path file, std::string driver) : file_(std::move(file)), driver_(std::move(driver)) {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  struct statx found {};
  if (statx(AT_FDCWD, program.c_str(), 0, STATX_SIZE | STATX_MTIME, &found) == 0)
    driver_ += " " + std::to_string(found.stx_size) + " " + std::to_string(found.stx_mtime.tv_sec);
}

std::string KernelRecord::key_of(const Scene& scene) const {
  const std::string cache = identity_of(driver_cache());
  if (file_.empty() || cache.empty()) return "";
  Scene solved = scene;  // without what kernels do not depend on
  solved.duration = 0;
  solved.display = {};
  solved.title.clear();
  solved.camera.reset();
  solved.camera_motion = {};
  for (Body& body : solved.bodies)
    for (TetRegion& region : body.regions) region.tets = {{0, 0}};  // any
  const std::string text = driver_ + "\n" + cache + "\n" + scene_to_json(solved, fs::temp_directory_path());
  ByteHash hash;
  hash.add({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  return hash_text(hash.value());
}

bool KernelRecord::same(const Scene& a, const Scene& b) const {
  const std::string key = key_of(a);
  return !key.empty() && key == key_of(b);
}

bool KernelRecord::has(const Scene& scene) const {
  const std::string key = key_of(scene);
  const std::vector<std::string> lines = lines_of(file_);
  return !key.empty() && std::find(lines.begin(), lines.end(), key) != lines.end();
}

void KernelRecord::add(const Scene& scene) const {
  const std::string key = key_of(scene);
  if (key.empty()) return;
  std::vector<std::string> lines = lines_of(file_);
  std::erase(lines, key);
  lines.push_back(key);
  std::string text;
  for (std::size_t i = lines.size() > kMostScenes ? lines.size() - kMostScenes : 0; i < lines.size(); ++i)
    text += lines[i] + "\n";
  try {
    fs::create_directories(file_.parent_path());
    write_file(file_, text);
  } catch (const std::exception&) {  // the next window begins with single kernels again
  }
}

}  // namespace fascia
