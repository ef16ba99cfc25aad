// How the panels look: colors, spacing and font, for one scale.
#pragma once

struct ImFont;
struct ImVec4;

namespace fascia::ui {

/// Sets style and fonts of the current ImGui context for a scale (1: 96 dots per inch). The font atlas must be uploaded again.
void apply_style(float scale);

/// Pixels of a length that is `points` at scale 1.
float px(float points);
ImFont* bold_font();

extern const ImVec4 kAccent, kText, kDim, kWarning, kDanger, kPanel;

}  // namespace fascia::ui
