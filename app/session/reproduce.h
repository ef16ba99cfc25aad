// The command line that brings back what the sliders made of a scene: the file, and a --set for every value that is no
// longer the file's.
#pragma once
#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace fascia {

/// The fewest --set texts "KEY=VALUE" that make `from` into `to`, which must be scenes of the same file. Keys of the
/// first body need no "bodies.0."; what a --set cannot say one by one (a key taken away, a region with a dot in its
/// name) is said by the whole around it. Throws Error where a key of the scene itself was taken away.
std::vector<std::string> sets_between(const Scene& from, const Scene& to);

/// "fascia view liver.json --set gravity=[0,0,0]", for a POSIX shell.
std::string command_line(const std::filesystem::path& file, const std::vector<std::string>& sets);

/// In single quotes, unless no character of it means anything to a shell.
std::string shell_quoted(const std::string& text);

/// command_line() for a scene as it is now, against its file (a scene, a mesh or a replay) as it is now. Throws Error
/// when that cannot be read any more.
std::string command_that_reproduces(const Scene& now);

}  // namespace fascia
