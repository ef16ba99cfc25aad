#include "base/dated_name.h"

#include <ctime>

namespace fascia {
namespace fs = std::filesystem;

fs::path dated_name(const std::string& ending) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char stamp[32];
  std::strftime(stamp, sizeof stamp, "%Y%m%d-%H%M%S", &local);
  const std::string stem = std::string("fascia-") + stamp;
  fs::path path = stem + ending;
  std::error_code ec;
  for (int n = 2; fs::exists(path, ec); ++n) path = stem + "-" + std::to_string(n) + ending;
  return path;
}

}  // namespace fascia
