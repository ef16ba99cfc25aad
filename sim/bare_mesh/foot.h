// What a body stands on: how firmly a set of contact points carries it.
#pragma once
#include <Eigen/Core>
#include <vector>

namespace fascia {

/// The tangent of the smallest angle by which a body tips over the convex hull of its contact points: the distance of
/// the center of mass from the hull's edge over its height above the ground. Negative if the body tips by itself, as
/// with fewer than three points. `contact`: points on the ground; `center`: of mass, seen from above.
double stability(std::vector<Eigen::Vector2d> contact, const Eigen::Vector2d& center, double height);

}  // namespace fascia
