// The content and style of a picture of the scene, apart from the camera.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <optional>

#include "base/ray.h"
#include "render/view/color_map.h"
#include "render/view/quality.h"

namespace fascia {

enum class Backdrop { gradient, white, black, transparent };

/// Separate tets: each is shrunk about its centroid, which is moved away from the scene's center by `spread` times its
/// distance.
struct TetSpread {
  float shrink, spread;
};

struct Look {
  bool wireframe = false;
  bool heat_map = false;  // color by position.w over `range`
  bool regions = false;   // color by region; otherwise by the tissues' paints
  Eigen::Vector2f range{0, 1};
  const ColorMapCurve* color_map = &color_maps::dusk;
  std::optional<float> neutral;  // the scalar in the middle of the map, which then extends equally far to both sides
  bool shadow = true, ground = true;
  bool fixed_dots = true;       // on fixed vertices
  float ambient_occlusion = 0;  // strength, 0 to 1
  float depth_cue = 0;          // share by which the back of the scene fades into the backdrop
  Backdrop backdrop = Backdrop::gradient;
  std::optional<SectionCut> section;  // this and the next apply to scenes with tets
  std::optional<TetSpread> tets;
  double ground_height = 0;         // of the ground plane along `up` [m]
  Eigen::Vector3d center{0, 0, 0};  // of the scene at rest [m]
  double radius = 1;                // of the scene at rest [m]: sets light, shadow and grid scale
  Eigen::Vector3d up{0, 1, 0};
  Quality quality;
};

/// Scalars at the two ends of the color map: `range`, or with a neutral scalar the interval that extends equally far to
/// both sides of it.
inline Eigen::Vector2f map_range(const Look& look) {
  if (!look.neutral) return look.range;
  const float reach = (look.range.array() - *look.neutral).abs().maxCoeff();
  return {*look.neutral - reach, *look.neutral + reach};
}

/// The springs of a grab as an arrow, from the grabbed patch to their target.
struct GrabArrow {
  Eigen::Vector3f from, to;
};

/// Color of the heat map's default curve at t in [0, 1], sRGB. The shader uses the same numbers, and a fully lit
/// surface shows them unchanged.
inline Eigen::Vector3f heat_color(float t) { return color_maps::dusk(t); }

inline float linear_of_srgb(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

/// The cut of a picture; none if the look shows separate tets, which are omitted whole instead.
inline std::optional<SectionCut> shown_cut(const Look& look) { return look.tets ? std::nullopt : look.section; }

}  // namespace fascia
