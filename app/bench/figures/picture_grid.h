// Pictures side by side in one PNG, with captions and the scale of their heat map.
#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "render/target/image.h"

namespace fascia {

struct Panel {
  Image picture;
  std::vector<std::string> caption;  // lines
};

struct PictureGrid {
  std::string title;
  std::string scale_label;    // with its unit
  Eigen::Vector2d range;      // of the heat map
  std::vector<Panel> panels;  // pictures of one size
  int columns = 2;
};

/// Uses gnuplot, which sets the text. Throws Error.
void write_grid(const std::filesystem::path& path, const PictureGrid& grid);

}  // namespace fascia
