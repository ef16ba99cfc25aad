// The scale of the heat map: colors with the smallest, the middle and the largest value.
#pragma once
#include <Eigen/Core>
#include <string>

namespace fascia {

/// At the right edge of the picture, in ImGui's background layer. `label` as "von Mises stress [Pa]".
void draw_color_bar(const std::string& label, const Eigen::Vector2f& range);

}  // namespace fascia
