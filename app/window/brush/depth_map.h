// Distances of the nearest visible tissue under the pixels of a part of the picture, on the CPU: what a lasso takes.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <vector>

namespace fascia {

class DepthMap {
 public:
  /// A corner of a triangle in the picture.
  struct Corner {
    double x, y;         // [pixels]
    double distance;     // from the eye along the line of sight [m], above 0
    double beyond = -1;  // the section plane [m]: above 0 the tissue is not shown
  };

  /// The pixels from `low` to `high`, both included.
  DepthMap(const Eigen::Vector2i& low, const Eigen::Vector2i& high);

  /// Triangles of closed surfaces, wound outward.
  void add(const Corner& a, const Corner& b, const Corner& c);
  /// After all triangles: where the eye looks through the section plane into the body, the cut is the nearest place.
  /// `distance_at` gives that of the plane at a place in the picture [m].
  void close_cut(const std::function<double(double x, double y)>& distance_at);

  /// [m]; infinite beside the tissue and outside of the map.
  double nearest(double x, double y) const;
  /// The largest of nearest() of the pixel and its eight neighbors: a place on the surface is visible if it is not
  /// farther away.
  double farthest_around(double x, double y) const;

 private:
  std::size_t index(int x, int y) const;

  Eigen::Vector2i low_, high_;
  std::vector<double> distance_;
  std::vector<int> inside_;  // surfaces entered minus those left in front of the section plane
};

}  // namespace fascia
