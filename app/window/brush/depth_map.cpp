#include "app/window/brush/depth_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fascia {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

// Twice the signed area of a triangle in the picture.
double area2(double ax, double ay, double bx, double by, double cx, double cy) {
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

}  // namespace

DepthMap::DepthMap(const Eigen::Vector2i& low, const Eigen::Vector2i& high) : low_(low), high_(high.cwiseMax(low)) {
  const auto count = static_cast<std::size_t>((high_ - low_ + Eigen::Vector2i::Ones()).prod());
  distance_.assign(count, kNothing);
  inside_.assign(count, 0);
}

std::size_t DepthMap::index(int x, int y) const {
  return static_cast<std::size_t>(y - low_.y()) * static_cast<std::size_t>(high_.x() - low_.x() + 1) +
         static_cast<std::size_t>(x - low_.x());
}

// 1 / distance, and everything linear on the triangle divided by the distance, are linear in the picture.
void DepthMap::add(const Corner& a, const Corner& b, const Corner& c) {
  const double area = area2(a.x, a.y, b.x, b.y, c.x, c.y);
  if (area == 0 || !std::isfinite(area)) return;
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  const auto from = [](double place, int low) {
    return std::max(low, static_cast<int>(std::max<double>(low, std::floor(place))));
  };
  const auto to = [](double place, int high) { return static_cast<int>(std::min<double>(high, std::floor(place))); };
  for (int y = from(top, low_.y()); y <= to(bottom, high_.y()); ++y)
    for (int x = from(left, low_.x()); x <= to(right, high_.x()); ++x) {
      const double px = x + 0.5, py = y + 0.5, u = area2(b.x, b.y, c.x, c.y, px, py) / area,
                   v = area2(c.x, c.y, a.x, a.y, px, py) / area, w = 1 - u - v;
      if (u < 0 || v < 0 || w < 0) continue;
      const double inverse = u / a.distance + v / b.distance + w / c.distance;
      const double beyond = u * a.beyond / a.distance + v * b.beyond / b.distance + w * c.beyond / c.distance;
      const std::size_t i = index(x, y);
      if (beyond > 0)
        inside_[i] += area > 0 ? -1 : 1;  // rows count downwards: triangles that face the eye have a negative area
      else
        distance_[i] = std::min(distance_[i], 1 / inverse);
    }
}

void DepthMap::close_cut(const std::function<double(double x, double y)>& distance_at) {
  for (int y = low_.y(); y <= high_.y(); ++y)
    for (int x = low_.x(); x <= high_.x(); ++x)
      if (const std::size_t i = index(x, y); inside_[i] > 0)
        distance_[i] = std::min(distance_[i], distance_at(x + 0.5, y + 0.5));
}

double DepthMap::nearest(double x, double y) const {
  const double column = std::floor(x), row = std::floor(y);
  if (!(column >= low_.x() && column <= high_.x() && row >= low_.y() && row <= high_.y())) return kNothing;
  return distance_[index(static_cast<int>(column), static_cast<int>(row))];
}

double DepthMap::farthest_around(double x, double y) const {
  double farthest = 0;
  for (const int dy : {-1, 0, 1})
    for (const int dx : {-1, 0, 1}) farthest = std::max(farthest, nearest(x + dx, y + dy));
  return farthest;
}

}  // namespace fascia
