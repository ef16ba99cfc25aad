// Completion for shells, generated from the command line's own tables: commands, options, choices, files by their
// extension, keys of --set.
#pragma once
#include <string>

#include "app/cli/command_tree.h"

namespace fascia {

std::string bash_completion(const CommandEntry& program);
std::string zsh_completion(const CommandEntry& program);
std::string fish_completion(const CommandEntry& program);

}  // namespace fascia
