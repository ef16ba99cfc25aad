#include "app/ui/field_labels.h"

#include <algorithm>
#include <cctype>

namespace fascia {

std::string label_of_field(const std::string& key) {
  if (key == "young_modulus") return "Young's modulus";
  if (key == "poisson_ratio") return "Poisson's ratio";
  if (key == "color") return "Heat map";
  std::string label = key;
  std::replace(label.begin(), label.end(), '_', ' ');
  if (!label.empty()) label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
  return label;
}

}  // namespace fascia
