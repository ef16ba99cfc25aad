// The content and look of a scene's pictures (scene key "display"). Names, titles and units of all choices are defined
// here once: for scene files, the command line, the panels and the color bar.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace fascia {

/// The quantity that colors the tissue. Stresses are principal stresses of the Cauchy stress; error: the distance from
/// the exact step.
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
  const char* name;                    // in scene files: "von_mises"
  const char* title;                   // "von Mises stress"
  const char* unit;                    // "Pa"; "" for none
  const char* help;                    // what it shows and what it costs
  std::optional<double> neutral = {};  // for quantities of both signs: middle of the color map
};
const Quantity& quantity_of(ColorBy color);
std::string label_of(ColorBy color);  // "von Mises stress [Pa]"
/// Whether a color map shows a number per vertex.
inline bool is_heat_map(ColorBy color) { return color != ColorBy::none && color != ColorBy::region; }

/// automatic: dusk, or polar for quantities with a neutral value.
enum class ColorMap { automatic, dusk, ember, polar, grey };
/// The map that `automatic` means for this quantity; any other map is returned unchanged.
ColorMap chosen_map(ColorMap map, ColorBy color);

/// The background behind the tissue. transparent: pictures have an alpha channel.
enum class Background { gradient, white, black, transparent };

// For each enumeration: all values, the name in scene files, and the description.
const std::vector<ColorBy>& all_colors();
const std::vector<ColorMap>& all_color_maps();
const std::vector<Background>& all_backgrounds();
inline const char* name_of(ColorBy color) { return quantity_of(color).name; }
const char* name_of(ColorMap map);
const char* name_of(Background background);
inline const char* help_of(ColorBy color) { return quantity_of(color).help; }
const char* help_of(ColorMap map);
const char* help_of(Background background);

/// Cuts the drawn body open: the part beyond the plane, normal . x > offset, is left out, and the cut is closed.
struct SectionPlane {
  Eigen::Vector3d normal{1, 0, 0};  // of any nonzero length, in the scene's coordinates
  double offset = 0;                // along the unit normal from the origin [m]
  bool operator==(const SectionPlane&) const = default;
};

/// Draws every tet separately instead of the surface.
struct SeparateTets {
  double shrink = 0.85;  // size of each about its centroid [-]
  double spread = 0;     // increase of the centroids' distance from the middle of the scene [-]: 1 doubles it
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
  double depth_cue = 0;          // fading of the back of the scene into the background, 0 (off) to 1
  Background background = Background::gradient;
  bool operator==(const DisplaySettings&) const = default;
};

/// f(field, key, label, help) for every setting. A field is a bool, a double from 0 to 1, one of the enumerations, or
/// an optional part.
template <class Settings, class F>
void visit_display(Settings& s, F&& f) {
  f(s.color, "color", "Color", "what colors the tissue");
  f(s.range, "range", "Range", "values of the first and the last color");
  f(s.color_map, "color_map", "Color map", "colors of the values");
  f(s.wireframe, "wireframe", "Wireframe", "Edges of the surface, and of the tets in a section (W)");
  f(s.section, "section", "Section",
    "Cuts the picture of the body open; what is inside shows in the colors of the heat map. One pass over the tets a "
    "frame");
  f(s.tets, "tets", "Separate tets",
    "Draws every tet on its own instead of the surface: 4 triangles a tet. With a section whole tets are left out");
  f(s.shadow, "shadow", "Shadow", "Draws the scene a second time, as the light sees it");
  f(s.ground, "ground", "Ground", "A floor with a grid; every line is a round number of meters");
  f(s.ambient_occlusion, "ambient_occlusion", "Occlusion",
    "Darkens creases and what stands close together [-]. 0 costs nothing; software renderers pay for every pixel");
  f(s.depth_cue, "depth_cue", "Depth cue", "How far the back of the scene fades into the background [-]");
  f(s.background, "background", "Background", "behind the tissue");
}

}  // namespace fascia
