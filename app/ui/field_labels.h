// Names for people of the keys that scene files have: "young_modulus" is "Young's modulus" in panels, history and
// labels alike.
#pragma once
#include <string>

namespace fascia {

/// A key without a name of its own becomes words: "rest_speed" is "Rest speed".
std::string label_of_field(const std::string& key);

}  // namespace fascia
