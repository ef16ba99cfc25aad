#include "base/json/json_write.h"

#include <cmath>
#include <cstdint>

namespace fascia {

nlohmann::ordered_json number_document(double value) {
  const bool is_whole = std::abs(value) < 1e9 && value == std::floor(value) && !(value == 0 && std::signbit(value));
  if (is_whole) return static_cast<std::int64_t>(value);
  return value;
}

nlohmann::ordered_json vector_document(const Eigen::Vector3d& v) {
  return nlohmann::ordered_json::array({number_document(v.x()), number_document(v.y()), number_document(v.z())});
}

}  // namespace fascia
