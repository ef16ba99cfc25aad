// The look of the panels: colors of a theme, spacing and font, for one scale.
#pragma once

struct ImFont;
struct ImVec4;

namespace fascia::ui {

/// The font of panels and labels [points].
inline constexpr float kFontSize = 14.5f;

/// Sets style and fonts of the current ImGui context for a scale (1: 96 dots per inch), with a legend in a font of its
/// own size [points]. The font atlas must be uploaded again.
void apply_style(float scale, float legend_font_size = kFontSize);

/// The user's factor on the scale of the monitor, from kLeastScale to kLargestScale. It takes effect in the next frame.
void set_interface_scale(float factor);
float interface_scale();
inline constexpr float kLeastScale = 0.6f, kLargestScale = 2.5f;

/// Pixels of a length that is `points` at scale 1.
float px(float points);
ImFont* bold_font();
ImFont* legend_font();

/// Themes of the panels, for dark and for bright rooms. A change takes effect at once.
enum class Theme { dark, light };
void set_theme(Theme wanted);
Theme theme();

/// Colors of the current theme.
extern const ImVec4 &kAccent, &kText, &kDim, &kGood, &kWarning, &kDanger, &kPanel;

}  // namespace fascia::ui
