// Generates the command line that reproduces a scene after changes with sliders: the file, and a --set for every value
// that differs from the file's.
#pragma once
#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace fascia {

/// The fewest --set texts "KEY=VALUE" that change `from` to `to`, which must be scenes of the same file. Keys of the
/// first body need no "bodies.0."; changes that a --set cannot express individually (a removed key, a region with a dot
/// in its name) are expressed by the enclosing value. Throws Error if a key of the scene itself was removed.
std::vector<std::string> sets_between(const Scene& from, const Scene& to);

/// "fascia view liver.json --set gravity=[0,0,0]", for a POSIX shell.
std::string command_line(const std::filesystem::path& file, const std::vector<std::string>& sets);

/// In single quotes, unless none of its characters is special to a shell.
std::string shell_quoted(const std::string& text);

/// command_line() for the current scene, relative to the current content of its file (a scene, a mesh or a replay).
/// Throws Error if that can no longer be read.
std::string command_that_reproduces(const Scene& now);

}  // namespace fascia
