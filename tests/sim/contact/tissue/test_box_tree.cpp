#include "sim/contact/tissue/box_tree.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/sim/reference/box_model.h"

namespace fascia {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

TEST_CASE("a tree of boxes finds every box that overlaps, also after they moved") {
  test::Random random(3);
  std::vector<Vector3d> middles;
  for (int i = 0; i < 500; ++i) middles.push_back(random.vector());
  BoxTree tree(middles);
  for (const double reach : {0.05, 0.3}) {
    std::vector<AlignedBox3d> boxes;
    for (Vector3d& x : middles) {
      x += 0.2 * random.vector();
      const Vector3d half = reach * random.vector().cwiseAbs();
      boxes.emplace_back(x - half, x + half);
    }
    tree.fit(boxes);
    for (int query = 0; query < 50; ++query) {
      const Vector3d x = random.vector();
      const AlignedBox3d box(x - Vector3d::Constant(0.1), x + Vector3d::Constant(0.1));
      std::vector<std::uint32_t> found, expected;
      tree.for_overlaps(box, [&](std::uint32_t k) {
        if (boxes[k].intersects(box)) found.push_back(k);
      });
      for (std::uint32_t k = 0; k < boxes.size(); ++k)
        if (boxes[k].intersects(box)) expected.push_back(k);
      std::sort(found.begin(), found.end());
      CHECK(found == expected);
    }
  }
}

TEST_CASE("a tree leaves out no thing that faces against a direction, and most of those that do not") {
  test::Random random(7);
  std::vector<Vector3d> middles;
  std::vector<AlignedBox3d> boxes, facings;
  for (int i = 0; i < 1000; ++i) {  // of a ball, each of which faces outward
    middles.push_back(random.vector().normalized());
    boxes.emplace_back(middles.back());
    facings.emplace_back(middles.back());
  }
  BoxTree tree(middles);
  tree.fit(boxes, facings);
  std::size_t visited = 0, opposed = 0;
  for (int query = 0; query < 50; ++query) {
    const Vector3d direction = random.vector();
    const AlignedBox3d everything(Vector3d(-1, -1, -1), Vector3d(1, 1, 1));
    std::vector<char> found(middles.size(), 0);
    tree.for_opposed(everything, direction, [&](std::uint32_t k) {
      found[k] = 1;
      ++visited;
    });
    for (std::size_t k = 0; k < middles.size(); ++k)
      if (middles[k].dot(direction) < 0) {
        ++opposed;
        CHECK(found[k]);
      }
  }
  CHECK(static_cast<double>(visited) < 1.3 * static_cast<double>(opposed));
}

TEST_CASE("a tree of nothing finds nothing") {
  const BoxTree tree{std::vector<Vector3d>()};
  CHECK(tree.empty());
  tree.for_overlaps(AlignedBox3d(Vector3d(-1, -1, -1), Vector3d(1, 1, 1)), [](std::uint32_t) { FAIL(); });
}

}  // namespace
}  // namespace fascia
