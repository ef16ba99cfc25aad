// The files that a command is going to write, looked at before its work begins: a mistyped folder must not cost hours
// of it.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace fascia {

struct OutputFile {
  std::string option, path;          // an empty path: not asked for; "-": standard output
  std::vector<std::string> endings;  // in small letters; empty: any
  enum class Takes {
    these,            // only these endings
    all_but_foreign,  // every ending but that of another kind of file
  } takes = Takes::these;
};

/// Throws UsageError for an ending that the option does not know, and where two outputs, or an output and one of
/// `inputs`, are one file; Error where a file cannot be written. A command asks twice: before it opens anything, and
/// again once it knows what it reads.
void require_outputs(const std::vector<OutputFile>& outputs, const std::vector<std::filesystem::path>& inputs = {});

}  // namespace fascia
