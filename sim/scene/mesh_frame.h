// What a mesh file does not state about its coordinates: their unit of length, and the axis that points up (scene keys
// "unit" and "up").
#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>

namespace fascia {

enum class LengthUnit { m, cm, mm, um, in };
enum class UpAxis { x, y, z, minus_x, minus_y, minus_z };

inline constexpr std::array kLengthUnits = {LengthUnit::m, LengthUnit::cm, LengthUnit::mm, LengthUnit::um,
                                            LengthUnit::in};
inline constexpr std::array kUpAxes = {UpAxis::x,       UpAxis::y,       UpAxis::z,
                                       UpAxis::minus_x, UpAxis::minus_y, UpAxis::minus_z};

/// As in scene files.
inline const char* name_of(LengthUnit unit) {
  constexpr std::array names = {"m", "cm", "mm", "um", "in"};
  return names[static_cast<std::size_t>(unit)];
}
inline const char* name_of(UpAxis up) {
  constexpr std::array names = {"x", "y", "z", "-x", "-y", "-z"};
  return names[static_cast<std::size_t>(up)];
}

inline double meters(LengthUnit unit) {
  constexpr std::array lengths = {1.0, 1e-2, 1e-3, 1e-6, 0.0254};
  return lengths[static_cast<std::size_t>(unit)];
}

/// The direction that points up, in the coordinates of the file.
inline Eigen::Vector3d direction(UpAxis up) {
  const auto index = static_cast<int>(up);
  return (index < 3 ? 1 : -1) * Eigen::Vector3d::Unit(index % 3);
}

/// The rotation by multiples of 90 degrees that turns `up` to y. Its entries are exact.
inline Eigen::Matrix3d turned_up(UpAxis up) {
  const Eigen::Vector3d y = direction(up);
  // The next axis after the one that points up keeps its sign: z up turns x to x, x up turns y to -x.
  const Eigen::Vector3d x = std::array<Eigen::Vector3d, 3>{-Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX(),
                                                           Eigen::Vector3d::UnitX()}[static_cast<std::size_t>(up) % 3];
  Eigen::Matrix3d rotation;
  rotation << x.transpose(), y.transpose(), x.cross(y).transpose();
  return rotation;
}

}  // namespace fascia
