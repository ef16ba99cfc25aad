#include "sim/obj_materials.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sim/error.h"
#include "sim/obj_lines.h"

namespace fascia {

std::uint32_t packed_color(double r, double g, double b) {
  const auto byte = [](double share) { return static_cast<std::uint32_t>(std::lround(255 * std::clamp(std::isnan(share) ? 0.0 : share, 0.0, 1.0))); };
  return byte(r) | byte(g) << 8 | byte(b) << 16 | 0xff000000u;
}

void ObjMaterials::read_libraries(const std::string& names, const Library& library) {
  try {
    read(library(names));
    return;
  } catch (const Error& missing) {
    if (names.find_first_of(" \t") == names.npos) {
      notes_.push_back(std::string(missing.what()) + ": drawn without its materials");
      return;
    }
  }
  std::istringstream words(names);
  for (std::string name; words >> name;) read_libraries(name, library);
}

void ObjMaterials::read(std::string_view content) {
  std::size_t current = 0;
  bool in_material = false;
  for_each_obj_line(content, [&](const ObjLine& line) {
    if (line.word == "newmtl") {
      current = number(line.rest);
      described_[current] = true;
      in_material = true;
    } else if (line.word == "Kd" && in_material) {
      std::istringstream numbers{std::string(line.rest)};  // none where the color is given as a spectrum
      if (double r, g, b; numbers >> r >> g >> b) materials_[current].color = packed_color(r, g, b);
    }
  });
}

std::size_t ObjMaterials::number(std::string_view name) {
  const auto known = std::find_if(materials_.begin(), materials_.end(), [&](const SurfaceMaterial& m) { return m.name == name; });
  if (known != materials_.end()) return static_cast<std::size_t>(known - materials_.begin());
  materials_.push_back({std::string(name), 0});
  described_.push_back(false);
  return materials_.size() - 1;
}

std::vector<SurfaceMaterial> ObjMaterials::take(std::vector<std::string>& notes) {
  if (notes_.empty())
    for (std::size_t m = 0; m < materials_.size(); ++m)
      if (!described_[m]) notes_.push_back("material " + materials_[m].name + " is in none of its libraries: drawn without it");
  notes.insert(notes.end(), notes_.begin(), notes_.end());
  return std::move(materials_);
}

}  // namespace fascia
