#include "sim/tool/tool_size.h"

#include <cmath>

#include "base/text.h"
#include "sim/tool/solid_mesh.h"

namespace fascia {

std::string note_of_size(const Tool& tool, double tissue) {
  constexpr double kTooLarge = 50;  // times the tissue: in meters instead of millimeters, a twentieth of it is
  const auto* mesh = std::get_if<MeshShape>(&tool.shape);
  const double size = mesh ? mesh->solid->box.sizes().maxCoeff() : 0;
  if (tissue == 0 || size <= kTooLarge * tissue) return "";
  return tool.name + ": " + length(size) + " wide, " + number(std::round(size / tissue)) +
         " times as large as the tissue: is \"scale\" of its mesh missing (0.001 for millimeters)?";
}

}  // namespace fascia
