// Generates the manual page from the command line's own tables, so that it always agrees with the program.
#pragma once
#include <string>

#include "app/cli/command_tree.h"

namespace fascia {

/// fascia.1 for man(1), in roff.
std::string manual_page(const CommandEntry& program);

}  // namespace fascia
