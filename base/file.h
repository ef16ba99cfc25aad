// Reads and writes whole files. A file is written under a temporary name beside its target and renamed, so that readers
// see the old file or the new one, never a part.
#pragma once
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

#include "base/progress.h"

namespace fascia {

/// Throws Error for a missing file, a directory, a device, a file that is mostly a hole or larger than the free memory,
/// a pipe without a writer, or a read that fails. A pipe is read once: later reads return the same content.
std::string read_file(const std::filesystem::path& path, const Progress& progress = {});

/// The whole content, read once: later calls return the same text.
const std::string& read_standard_input();

/// The command line's name for standard input or output, for options that accept it.
inline constexpr const char* kStandardInput = "-";
inline constexpr const char* kStandardOutput = "-";

/// The final target of the symbolic links at `path`, whether a file exists there or not; `path` itself if it is no
/// link. Throws Error for circular links.
std::filesystem::path link_target(const std::filesystem::path& path);

/// Throws Error (missing folder, no permission, read-only file, disk full); the old file is then unchanged. A symbolic
/// link is kept and its target replaced or created; a device or a pipe (/dev/stdout) is written directly, and so is
/// standard output.
void write_file(const std::filesystem::path& path, std::string_view content);
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& writer);

/// Throws as write_file() would, as far as that can be known in advance: called before long work with a result for that
/// file.
void require_writable(const std::filesystem::path& path);

/// A name beside `path`, or beside the target of that link, for a file that is being written, different at every call
/// (with the same extension, so that child processes recognize the format). It contains the process id.
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Renames a finished temporary file to `path`, or to the target of that link, and removes temporary files that other
/// processes left for it when they were killed. Throws Error, after removing the temporary file.
void replace_file(const std::filesystem::path& temporary, const std::filesystem::path& path);

/// ".msh" of "Beam.MSH": identifies the format.
std::string lower_ending(const std::filesystem::path& path);

}  // namespace fascia
