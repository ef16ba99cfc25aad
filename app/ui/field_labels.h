// Display names of the keys in scene files: "young_modulus" is "Young's modulus" in panels, history and labels alike.
#pragma once
#include <string>

namespace fascia {

/// A key without a name of its own is converted to words: "rest_speed" is "Rest speed".
std::string label_of_field(const std::string& key);

}  // namespace fascia
