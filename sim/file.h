// Whole files in and out. A file is written under a temporary name beside its target and renamed, so that
// whoever looks sees the old file or the new one, never half of it.
#pragma once
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace fascia {

/// Throws Error for a missing file, a directory, a device, or a read that fails.
std::string read_file(const std::filesystem::path& path);

/// Throws Error (missing folder, no permission, disk full); the old file is untouched then. A symbolic link
/// stays and its target is replaced; a device or a pipe (/dev/stdout) is written to directly.
void write_file(const std::filesystem::path& path, std::string_view content);
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& writer);

/// A name beside `path` for a file still being written (same ending, so that child processes know the
/// format).
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// ".msh" of "Beam.MSH": how formats are told apart.
std::string lower_ending(const std::filesystem::path& path);

}  // namespace fascia
