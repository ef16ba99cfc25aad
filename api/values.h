// Converts numbers and arrays of the public interface to the library's own types, and back.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "base/progress.h"
#include "fascia/control.h"
#include "fascia/error.h"

namespace fascia::api {

inline Vec3 array_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Throws Error if a component is not finite.
inline Eigen::Vector3d vector_of(const Vec3& v, const std::string& where) {
  for (const double c : v)
    if (!std::isfinite(c)) throw Error(where, "is not finite", "expected three finite numbers");
  return {v[0], v[1], v[2]};
}

/// [count][3] numbers. Throws Error for another count or numbers that are not finite.
inline std::vector<Eigen::Vector3d> vectors_of(std::span<const double> numbers, std::size_t count,
                                               const std::string& where) {
  if (numbers.size() != 3 * count)
    throw Error(where, "has " + std::to_string(numbers.size()) + " numbers",
                "expected " + std::to_string(3 * count) + ", three a vertex");
  std::vector<Eigen::Vector3d> vectors(count);
  for (std::size_t v = 0; v < count; ++v) {
    vectors[v] = {numbers[3 * v], numbers[3 * v + 1], numbers[3 * v + 2]};
    if (!vectors[v].allFinite())
      throw Error(where, "is not finite at vertex " + std::to_string(v), "expected finite numbers");
  }
  return vectors;
}

inline std::vector<double> numbers_of(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<double> numbers;
  numbers.reserve(3 * vectors.size());
  for (const Eigen::Vector3d& v : vectors) numbers.insert(numbers.end(), {v.x(), v.y(), v.z()});
  return numbers;
}

/// For a visitor of a settings table (visit_material, visit_settings): throws Error "material.young_modulus: is -5;
/// expected 0.001 to 1e+14 Pa" for a field out of range.
struct RangeCheck {
  std::string where;
  template <class T, class N>
  void operator()(const T& field, const char* name, const char* unit, N least, N most, bool, const char*) const {
    const auto value = static_cast<double>(field);
    if (value >= static_cast<double>(least) && value <= static_cast<double>(most)) return;
    const std::string end = *unit ? std::string(" ") + unit : "";
    const auto text = [](double number) { return NumberText().add(number).take(); };
    throw Error(where + "." + name, "is " + text(value),
                "expected " + text(static_cast<double>(least)) + " to " + text(static_cast<double>(most)) + end);
  }
};

/// Throws Interrupted from work that reports its progress.
inline Progress progress_of(const Control& control, const std::string& what) {
  return [control, what](double share, const char* next) {
    if (control.stop.stop_requested()) throw Interrupted(what + ": interrupted");
    if (control.progress) control.progress(share, next);
  };
}

}  // namespace fascia::api
