// What the pictures of a scene show and how (scene key "display"). Names, titles and units of everything that can be
// chosen stand here once: for scene files, the command line, the panels and the color bar.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace fascia {

/// What colors the tissue. Stresses are principal stresses of the Cauchy stress; error: distance to the exact step.
enum class ColorBy {
  none,
  region,
  strain,
  von_mises,
  displacement,
  velocity,
  volume_ratio,
  largest_stress,
  smallest_stress,
  error
};

struct Quantity {
  const char* name;   // in scene files: "von_mises"
  const char* title;  // "von Mises stress"
  const char* unit;   // "Pa"; "" for none
  std::optional<double>
      neutral;  // of quantities that go both ways from a value of rest: the middle of a diverging color map
};
const Quantity& quantity_of(ColorBy color);
inline const char* name_of(ColorBy color) { return quantity_of(color).name; }
std::string label_of(ColorBy color);  // "von Mises stress [Pa]"
const std::vector<ColorBy>& all_colors();
/// Whether it is a number per vertex, shown by a color map.
inline bool is_heat_map(ColorBy color) { return color != ColorBy::none && color != ColorBy::region; }

/// automatic: dusk, or polar for quantities with a neutral value.
enum class ColorMap { automatic, dusk, ember, polar, grey };
const char* name_of(ColorMap map);
const std::vector<ColorMap>& all_color_maps();
/// What `automatic` is for this quantity; any other map is itself.
ColorMap chosen_map(ColorMap map, ColorBy color);

/// Behind the tissue. transparent: pictures have an alpha channel.
enum class Background { gradient, white, black, transparent };
const char* name_of(Background background);
const std::vector<Background>& all_backgrounds();

/// Cuts the drawn body open: what lies beyond, normal . x > offset, is left out, and the cut is closed.
struct SectionPlane {
  Eigen::Vector3d normal{1, 0, 0};  // of any length but zero, in the scene's coordinates
  double offset = 0;                // along the unit normal from the origin [m]
  bool operator==(const SectionPlane&) const = default;
};

/// Draws every tet on its own instead of the surface.
struct SeparateTets {
  double shrink = 0.85;  // size of each about its centroid [-]
  double spread = 0;  // how much farther from the middle of the scene centroids are drawn [-]: 1 doubles their distance
  bool operator==(const SeparateTets&) const = default;
};

struct DisplaySettings {
  ColorBy color = ColorBy::none;
  std::optional<Eigen::Vector2d> range;  // of the color map in the quantity's unit; absent: automatic
  ColorMap color_map = ColorMap::automatic;
  bool wireframe = false;
  std::optional<SectionPlane> section;
  std::optional<SeparateTets> tets;
  bool shadow = true, ground = true;
  double ambient_occlusion = 0;  // strength, 0 (off) to 1
  double depth_cue = 0;          // how far the back of the scene fades into the background, 0 (off) to 1
  Background background = Background::gradient;
  bool operator==(const DisplaySettings&) const = default;
};

}  // namespace fascia
