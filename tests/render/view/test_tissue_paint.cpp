// Paints as the shaders read them.
#include "render/view/tissue_paint.h"

#include <catch2/catch.hpp>

#include "render/view/look.h"

namespace fascia {

TEST_CASE("a packed paint has linear colors, patches as a factor and lengths in meters") {
  const TissuePaint paint{.color = {0.5f, 0.25f, 1},
                          .over_corners = true,
                          .patches = {0.25f, 0.25f, 0.5f},
                          .lines = {1, 1, 0},
                          .patch_size = 0.2f,
                          .patchiness = 0.5f,
                          .line_share = 0.25f,
                          .stretch = 3,
                          .bumpiness = 0.1f,
                          .wetness = 0.75f,
                          .scattering = 1};
  const auto vectors = packed(paint, 0.05);
  CHECK(vectors[0].x() == linear_of_srgb(0.5f));
  CHECK(vectors[0].w() == 1);
  for (int k = 0; k < 3; ++k) CHECK(vectors[0][k] * vectors[1][k] == Approx(linear_of_srgb(paint.patches[k])));
  CHECK(vectors[1].w() == 0.5f);
  CHECK(vectors[2] == Eigen::Vector4f(1, 1, 0, 0.25f));
  CHECK(vectors[3].x() == Approx(100));  // 0.2 of 0.05 m are a hundredth of a meter
  CHECK(vectors[3].tail<3>() == Eigen::Vector3f(3, 0.1f, 0.75f));
  // The brightest channel scatters farthest.
  CHECK(vectors[4].z() > vectors[4].x());
  CHECK(vectors[4].x() > vectors[4].y());
  CHECK(vectors[4].y() > 0);
}

TEST_CASE("a black paint has finite patches") {
  TissuePaint paint;
  paint.color.setZero();
  for (const Eigen::Vector4f& vector : packed(paint, 1)) CHECK(vector.allFinite());
}

}  // namespace fascia
