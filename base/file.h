// Whole files in and out. A file is written under a temporary name beside its target and renamed, so that
// whoever looks sees the old file or the new one, never half of it.
#pragma once
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

#include "base/progress.h"

namespace fascia {

/// Throws Error for a missing file, a directory, a device, a file that is mostly a hole or larger than the memory that
/// is free, a pipe into which nothing writes, or a read that fails. A pipe is read once: whoever reads it again gets
/// the same content.
std::string read_file(const std::filesystem::path& path, const Progress& progress = {});

/// The whole of it, read once: asked again, it is the same text.
const std::string& read_standard_input();

/// The name that stands for standard input or output on the command line, where an option takes it.
inline constexpr const char* kStandardInput = "-";
inline constexpr const char* kStandardOutput = "-";

/// The path to which symbolic links lead from `path`, whether a file is there or not; `path` itself where it is no
/// link. Throws Error for links that lead in a circle.
std::filesystem::path link_target(const std::filesystem::path& path);

/// Throws Error (missing folder, no permission, read-only file, disk full); the old file is untouched then. A
/// symbolic link stays and its target is replaced, or made; a device or a pipe (/dev/stdout) is written to directly,
/// and so is standard output.
void write_file(const std::filesystem::path& path, std::string_view content);
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& writer);

/// Throws as write_file() would, as far as that can be known before: to be asked before long work whose result goes
/// there.
void require_writable(const std::filesystem::path& path);

/// A name beside `path`, or beside the target of that link, for a file still being written, another one at every call
/// (same ending, so that child processes know the format). Its process is part of the name.
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Renames a finished temporary file to `path`, or to the target of that link, and removes the temporary files that
/// other processes left of it when they were killed. Throws Error; the temporary file is removed then.
void replace_file(const std::filesystem::path& temporary, const std::filesystem::path& path);

/// ".msh" of "Beam.MSH": how formats are told apart.
std::string lower_ending(const std::filesystem::path& path);

}  // namespace fascia
