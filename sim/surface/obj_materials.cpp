#include "sim/surface/obj_materials.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/error.h"
#include "sim/surface/obj_lines.h"

namespace fascia {
namespace {

constexpr std::size_t kMostNotes = 8;  // of one kind

}  // namespace

std::uint32_t packed_color(double r, double g, double b) {
  const auto byte = [](double share) {
    return static_cast<std::uint32_t>(std::lround(255 * std::clamp(std::isnan(share) ? 0.0 : share, 0.0, 1.0)));
  };
  return byte(r) | byte(g) << 8 | byte(b) << 16 | 0xff000000u;
}

void ObjMaterials::read_libraries(const std::string& names, const Library& library) {
  if (!libraries_.insert(names).second) return;  // exporters repeat the line before every object
  try {
    read(library(names));
    return;
  } catch (const Error& missing) {
    if (names.find_first_of(" \t") == names.npos) {
      if (missing_++ < kMostNotes) notes_.push_back(std::string(missing.what()) + ": drawn without its materials");
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
      std::istringstream numbers{std::string(line.rest)};  // empty if the color is given as a spectrum
      if (double r, g, b; numbers >> r >> g >> b) materials_[current].color = packed_color(r, g, b);
    }
  });
}

std::size_t ObjMaterials::number(std::string_view name) {
  const auto [entry, is_new] = number_of_.emplace(name, materials_.size());
  if (is_new) {
    materials_.push_back({std::string(name), 0});
    described_.push_back(false);
  }
  return entry->second;
}

std::vector<SurfaceMaterial> ObjMaterials::take(std::vector<std::string>& notes) {
  if (missing_ > kMostNotes)
    notes_.push_back(std::to_string(missing_ - kMostNotes) + " more libraries of materials are missing");
  if (notes_.empty()) {
    std::size_t unknown = 0;
    for (std::size_t m = 0; m < materials_.size(); ++m)
      if (!described_[m] && unknown++ < kMostNotes)
        notes_.push_back("material " + materials_[m].name + " is in none of its libraries: drawn without it");
    if (unknown > kMostNotes)
      notes_.push_back(std::to_string(unknown - kMostNotes) + " more materials are in none of the libraries");
  }
  notes.insert(notes.end(), notes_.begin(), notes_.end());
  return std::move(materials_);
}

}  // namespace fascia
