// How the surface of one tissue is drawn.
#pragma once
#include <Eigen/Core>
#include <array>

namespace fascia {

struct TissuePaint {
  Eigen::Vector3f color{0.80f, 0.34f, 0.29f};  // sRGB, as all colors here
  bool over_corners = false;                   // the color also replaces those of the surface's corners
  Eigen::Vector3f patches{0.80f, 0.34f, 0.29f}, lines{0.80f, 0.34f, 0.29f};
  float patch_size = 0.2f;  // of the largest patches, in scene radii
  float patchiness = 0;     // 0 to 1
  float line_share = 0;     // 0 to 1
  float stretch = 1;        // of patches and bumps along the longest side of the rest shape
  float bumpiness = 0;      // slope of the bumps
  float wetness = 0.6f;     // 0 to 1
  float scattering = 0.5f;  // 0 to 1
  bool operator==(const TissuePaint&) const = default;
};

constexpr std::size_t kPaintVectors = 5;
/// The paint as draw/paint.glsl reads it, in linear colors and for a scene of this radius [m].
std::array<Eigen::Vector4f, kPaintVectors> packed(const TissuePaint& paint, double radius);

}  // namespace fascia
