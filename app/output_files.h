// The files that a command is going to write, looked at before its work begins: a mistyped folder must not cost hours of it.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace fascia {

struct OutputFile {
  std::string option, path;          // an empty path: not asked for
  std::vector<std::string> endings;  // in small letters; empty: any
};

/// Throws UsageError for an ending that the option does not know, and where two outputs, or an output and one of `inputs`, are one file;
/// Error where a file cannot be written.
void require_outputs(const std::vector<OutputFile>& outputs, const std::vector<std::filesystem::path>& inputs);

}  // namespace fascia
