// Tools whose size is likely a mistake, such as that of a file in millimeters that is read as meters.
#pragma once
#include <string>

#include "sim/tool/tool.h"

namespace fascia {

/// "tool: 80 m wide, 800 times as large as the tissue: ..." for a mesh that is much larger than the tissue, whose
/// largest side is `tissue` [m]; otherwise nothing. Other shapes state their sizes in meters beside the key.
std::string note_of_size(const Tool& tool, double tissue);

}  // namespace fascia
