// The content and look of a scene's pictures (scene key "display"). Names, titles and units of all choices are defined
// here once: for scene files, the command line, the panels and the color bar.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace fascia {

/// The quantity that colors the tissue. Stresses are principal stresses of the Cauchy stress; error: the distance from
/// the exact step; contact_pressure: normal forces of contact over the area at rest; mesh_error: the estimated error of
/// the mesh.
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
  error,
  contact_pressure,
  mesh_error,
  recovered_von_mises
};

struct Quantity {
  const char* name;                    // in scene files: "von_mises"
  const char* title;                   // "Von Mises stress"
  const char* unit;                    // "Pa"; "" for none
  const char* help;                    // what it shows and what it costs
  std::optional<double> neutral = {};  // for quantities of both signs: middle of the color map
};
const Quantity& quantity_of(ColorBy color);
std::string label_of(ColorBy color);  // "Von Mises stress [Pa]"
/// Whether a color map shows a number per vertex.
inline bool is_heat_map(ColorBy color) { return color != ColorBy::none && color != ColorBy::region; }

/// automatic: dusk, or polar for quantities with a neutral value.
enum class ColorMap { automatic, dusk, ember, polar, grey };
/// The map that `automatic` means for this quantity; any other map is returned unchanged.
ColorMap chosen_map(ColorMap map, ColorBy color);

/// The background behind the tissue. transparent: pictures have an alpha channel.
enum class Background { gradient, white, black, transparent };

/// The edge of the picture at which the legend stands: the color bar, or the names of the regions.
enum class LegendSide { right, left, off };

// For each enumeration: all values, the name in scene files, and the description.
const std::vector<ColorBy>& all_colors();
const std::vector<ColorMap>& all_color_maps();
const std::vector<Background>& all_backgrounds();
const std::vector<LegendSide>& all_legend_sides();
inline const char* name_of(ColorBy color) { return quantity_of(color).name; }
const char* name_of(ColorMap map);
const char* name_of(Background background);
const char* name_of(LegendSide side);
inline const char* help_of(ColorBy color) { return quantity_of(color).help; }
const char* help_of(ColorMap map);
const char* help_of(Background background);
const char* help_of(LegendSide side);

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

/// The marks over the tissue. In scene files: true (all), false (none), or a list of names.
struct MarkSettings {
  bool fixed = true;   // dots on fixed and prescribed vertices
  bool grabs = true;   // grabbed vertices, arrows from the tissue to the target, handles
  bool forces = true;  // of the grabs, as texts [N]
  bool operator==(const MarkSettings&) const = default;
};

/// f(field, name, help) for every kind of mark.
template <class M, class F>
void visit_marks(M& marks, F&& f) {
  f(marks.fixed, "fixed", "Dots on fixed and prescribed vertices");
  f(marks.grabs, "grabs", "Grabbed vertices, and an arrow from the tissue to the target of every grab");
  f(marks.forces, "forces", "Forces of the grabs in newtons");
}

struct LegendSettings {
  LegendSide side = LegendSide::right;
  double font_size = 14.5;  // [points] of a picture of 720 rows; the bar grows with it
  bool plate = true;        // behind the legend
  bool operator==(const LegendSettings&) const = default;
};

struct DisplaySettings {
  ColorBy color = ColorBy::none;
  std::optional<Eigen::Vector2d> range;  // of the color map in the quantity's unit; absent: follows the values
  ColorMap color_map = ColorMap::automatic;
  bool wireframe = false;
  std::optional<SectionPlane> section;
  std::optional<SeparateTets> tets;
  bool shadow = true, ground = true;
  double ambient_occlusion = 0;  // strength, 0 (off) to 1
  double depth_cue = 0;          // fading of the back of the scene into the background, 0 (off) to 1
  Background background = Background::gradient;
  MarkSettings marks;
  LegendSettings legend;
  bool operator==(const DisplaySettings&) const = default;
};

/// f(field, key, label, help) for every setting. A field is a bool, a double from 0 to 1, one of the enumerations, a
/// part of several values, or an optional part.
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
  f(s.marks, "marks", "Marks", "Dots on fixed vertices; grabs with their vertices, arrows and forces");
  f(s.legend, "legend", "Legend", "The color bar or the names of the regions");
}

}  // namespace fascia
