// Checks the files that a command will write before its work begins: a mistyped folder must not cost hours of work.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace fascia {

struct OutputFile {
  std::string option, path;          // empty path: not requested; "-": standard output
  std::vector<std::string> endings;  // in lower case; empty: any
  enum class Takes {
    these,            // only these extensions
    all_but_foreign,  // every extension except those of other kinds of files
  } takes = Takes::these;
};

/// Throws UsageError for an extension that the option does not support, and if two outputs, or an output and one of
/// `inputs`, are the same file; Error if a file cannot be written. A command calls it twice: before it opens anything,
/// and again when its inputs are known.
void require_outputs(const std::vector<OutputFile>& outputs, const std::vector<std::filesystem::path>& inputs = {});

}  // namespace fascia
