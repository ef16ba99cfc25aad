#include "sim/contact/penetration.h"

#include "sim/contact/box_tree.h"
#include "sim/contact/tissue_surface.h"

namespace fascia {

using Eigen::Vector3d;

bool goes_through(const Vector3d& p, const Vector3d& q, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double above = signed_volume6(a, b, c, p), below = signed_volume6(a, b, c, q);
  if ((above > 0) == (below > 0) || above == 0 || below == 0) return false;
  const bool ab = signed_volume6(p, q, a, b) > 0, bc = signed_volume6(p, q, b, c) > 0,
             ca = signed_volume6(p, q, c, a) > 0;
  return ab == bc && bc == ca;
}

std::size_t penetrating_triangles(const Model& model, const std::vector<Vector3d>& displacement) {
  const std::vector<Triangle> triangles = tissue_boundary(model);
  std::vector<std::array<Vector3d, 3>> corners;
  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<Vector3d> middles;
  for (const Triangle& t : triangles) {
    std::array<Vector3d, 3>& x = corners.emplace_back();
    Eigen::AlignedBox3d& box = boxes.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) box.extend(x[k] = model.rest_positions[t[k]] + displacement[t[k]]);
    middles.push_back(box.center());
  }
  BoxTree tree(middles);
  tree.fit(boxes);
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    tree.for_overlaps(boxes[i], [&](std::uint32_t j) {
      if (j <= i) return;
      for (const std::uint32_t v : triangles[i])
        for (const std::uint32_t w : triangles[j])
          if (v == w) return;
      const auto &x = corners[i], &y = corners[j];
      for (std::size_t k = 0; k < 3; ++k)
        if (goes_through(x[k], x[(k + 1) % 3], y[0], y[1], y[2]) ||
            goes_through(y[k], y[(k + 1) % 3], x[0], x[1], x[2])) {
          ++count;
          return;
        }
    });
  return count;
}

}  // namespace fascia
