// A closed curve around tissue in the picture, and what lies within it.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/window/brush/stroke.h"

namespace fascia {

class Lasso {
 public:
  void begin(const Eigen::Vector2d& at) { curve_ = {at}; }
  void move(const Eigen::Vector2d& at);  // does nothing before begin()
  bool drawing() const { return !curve_.empty(); }
  const std::vector<Eigen::Vector2d>& curve() const { return curve_; }  // [pixels]; its ends are joined
  std::vector<Eigen::Vector2d> finish();                                // the curve; none is left

 private:
  std::vector<Eigen::Vector2d> curve_;
};

/// The vertices on the boundary of the tets that are visible within the curve, ascending.
std::vector<std::uint32_t> vertices_within(const std::vector<Eigen::Vector2d>& curve, BrushedPicture picture,
                                           Session& session);
/// The tets that are not cut away and whose centroids are within the curve, ascending: of those with a corner at most
/// `depth` [m] behind the visible tissue, or, without a depth, all.
std::vector<std::uint32_t> tets_within(const std::vector<Eigen::Vector2d>& curve, BrushedPicture picture,
                                       Session& session, std::optional<double> depth);

}  // namespace fascia
