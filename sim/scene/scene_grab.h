// A scripted grab (scene key "grabs", option --grab): grabs a patch at a given time, moves it along a path and releases
// it, so that tests, demos and measurements need no mouse.
#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "sim/scene/scene_selection.h"

namespace fascia {

struct ScriptedGrab {
  /// "at": a point on or near the tissue at rest, with transforms applied [m]; or "select": vertices of `body`.
  std::variant<Eigen::Vector3d, Selection> where = Eigen::Vector3d(0, 0, 0);
  std::string body;                 // by name; empty: the body at that point, or the first one
  std::optional<double> radius;     // of the patch around "at" [m]; absent: 0.08 of half the scene's diagonal
  std::optional<double> stiffness;  // of all springs together [N/m]; absent: from the tissue
  double start = 0, duration = 0;   // [s]
  std::optional<double> release;    // [s] absent: never
  bool smooth = false;              // ease in and out at every key of the path

  struct Key {
    double time;                   // after start [s]
    Eigen::Vector3d displacement;  // [m]
    bool operator==(const Key&) const = default;
  };
  // One of three: target reached in `duration`, depth into the surface reached in `duration`, or a path of keys.
  Eigen::Vector3d translate{0, 0, 0};  // [m]
  std::optional<double> push;          // [m]
  std::vector<Key> path;               // times ascending
  bool operator==(const ScriptedGrab&) const = default;
};

}  // namespace fascia
