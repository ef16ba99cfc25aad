// The one thing that a scene moves: a measurement of force against displacement has its displacement instead of a time.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "sim/model/model.h"

namespace fascia {

class Drive {
 public:
  /// The scene's prescribed translation, grab or instrument. Throws Error "WHERE: ..." if there is not exactly one.
  Drive(const Model& model, const std::string& where);

  double distance(double time) const { return distance_(time); }  // [m] from its place at time 0
  /// The first time at which the distance is reached [s]; none if it never is.
  std::optional<double> time_of(double distance) const;
  double farthest() const;  // [m]

 private:
  std::function<double(double time)> distance_;
  double end_ = 0;  // [s] nothing moves after this time
};

}  // namespace fascia
