#include "render/view/tissue_paint.h"

#include "render/view/look.h"

namespace fascia {
namespace {

Eigen::Vector4f linear(const Eigen::Vector3f& srgb, float w) {
  return {linear_of_srgb(srgb.x()), linear_of_srgb(srgb.y()), linear_of_srgb(srgb.z()), w};
}

}  // namespace

std::array<Eigen::Vector4f, kPaintVectors> packed(const TissuePaint& paint, double radius) {
  constexpr float kBlackest = 1e-3f;
  const Eigen::Vector4f color = linear(paint.color, paint.over_corners ? 1.0f : 0.0f);
  // Patches are a factor of the color, so that they are seen on the colors of corners, too.
  Eigen::Vector4f patches = linear(paint.patches, 0).cwiseQuotient(color.cwiseMax(kBlackest));
  patches.w() = paint.patchiness;
  // Light below the surface takes the tissue's color: what is absorbed least travels farthest.
  const Eigen::Vector3f travel = color.head<3>().cwiseSqrt();
  const Eigen::Vector3f wrap = paint.scattering * 0.45f * travel / std::max(travel.maxCoeff(), kBlackest);
  return {color, patches, linear(paint.lines, paint.line_share),
          Eigen::Vector4f(1 / (paint.patch_size * static_cast<float>(radius)), paint.stretch, paint.bumpiness,
                          paint.wetness),
          Eigen::Vector4f(wrap.x(), wrap.y(), wrap.z(), 0)};
}

}  // namespace fascia
