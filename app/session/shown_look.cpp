#include "app/session/shown_look.h"

#include <algorithm>
#include <cmath>

#include "sim/material/tissue_looks.h"

namespace fascia {
namespace {

// The next 1, 2 or 5 times a power of ten.
double round_up(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * decade) return step * decade;
  return 10 * decade;
}

const ColorMapCurve& curve_of(ColorMap map) {
  switch (map) {
    case ColorMap::ember:
      return color_maps::ember;
    case ColorMap::polar:
      return color_maps::polar;
    case ColorMap::grey:
      return color_maps::grey;
    default:
      return color_maps::dusk;
  }
}

Backdrop backdrop_of(Background background) {
  switch (background) {
    case Background::white:
      return Backdrop::white;
    case Background::black:
      return Backdrop::black;
    case Background::transparent:
      return Backdrop::transparent;
    default:
      return Backdrop::gradient;
  }
}

Eigen::Vector3f vector_of(const SrgbColor& color) { return {color[0], color[1], color[2]}; }

}  // namespace

TissuePaint paint_of(const Material& material) {
  const TissueLook& look = material.look ? *material.look : tissue_looks().front();
  TissuePaint paint{.color = vector_of(look.color),
                    .patches = vector_of(look.patches),
                    .lines = vector_of(look.lines),
                    .patch_size = look.patch_size,
                    .patchiness = look.patchiness,
                    .line_share = look.line_share,
                    .stretch = look.stretch,
                    .bumpiness = look.bumpiness,
                    .wetness = look.wetness,
                    .scattering = look.scattering};
  if (!material.color) return paint;
  const auto [red, green, blue] = *material.color;
  const Eigen::Vector3f color = Eigen::Vector3d(red, green, blue).cast<float>();
  // Patches and lines differ from the material's color as they differ from the look's.
  constexpr float kDarkest = 0.02f;
  const Eigen::Vector3f change = color.cwiseQuotient(paint.color.cwiseMax(kDarkest));
  paint.patches = paint.patches.cwiseProduct(change).cwiseMin(1);
  paint.lines = paint.lines.cwiseProduct(change).cwiseMin(1);
  paint.color = color;
  paint.over_corners = true;
  return paint;
}

void show(const DisplaySettings& display, Look& look) {
  look.heat_map = is_heat_map(display.color);
  look.regions = display.color == ColorBy::region;
  if (display.range) look.range = display.range->cast<float>();
  const ColorMap map = chosen_map(display.color_map, display.color);
  look.color_map = &curve_of(map);
  look.neutral.reset();
  if (const auto neutral = quantity_of(display.color).neutral; neutral && map == ColorMap::polar)
    look.neutral = static_cast<float>(*neutral);
  look.wireframe = display.wireframe;
  look.section.reset();
  if (display.section)
    look.section = {display.section->normal.normalized().cast<float>(), static_cast<float>(display.section->offset)};
  look.tets.reset();
  if (display.tets) look.tets = {static_cast<float>(display.tets->shrink), static_cast<float>(display.tets->spread)};
  look.shadow = display.shadow;
  look.ground = display.ground;
  look.fixed_dots = display.marks.fixed;
  look.ambient_occlusion = static_cast<float>(display.ambient_occlusion);
  look.depth_cue = static_cast<float>(display.depth_cue);
  look.backdrop = backdrop_of(display.background);
}

void follow_range(const ShownValues& shown, ColorBy color, bool only_grows, std::optional<Eigen::Vector2f>& range) {
  constexpr double kLeastShare = 0.1;  // of the largest value: a small patch under load must not be of one color
  const auto neutral = quantity_of(color).neutral;
  const double middle = neutral.value_or(0), farthest = std::max(shown.largest - middle, middle - shown.smallest),
               wanted = std::max(shown.usual, kLeastShare * (neutral ? farthest : shown.largest));
  if (!(wanted > 0) || !std::isfinite(wanted)) return;
  const double reach = range ? range->y() - middle : 0;
  if (wanted <= reach && (only_grows || wanted >= 0.2 * reach)) return;
  // Closer to a neutral value of 1, float32 has no accuracy left.
  const double next = std::max(round_up(wanted), middle == 0 ? 0.0 : 1e-5);
  range = Eigen::Vector2d(neutral ? middle - next : 0, middle + next).cast<float>();
}

}  // namespace fascia
