// A folder of scenes whose pictures and states must not change: its scenes (NAME.json) and replays (NAME.fascia), the
// goldens beside them (NAME.golden.png, NAME.golden.csv), and optionally a strict check.json with settings other than
// the defaults (format: docs/guide/regression.md).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/options.h"

namespace fascia {

struct CheckCase {
  std::string name;       // of the goldens, and of the files of a failure
  RenderOptions options;  // input, steps, size, goldens, limits
};

/// The cases in the order of their names. Throws Error for a folder without scenes and for errors in check.json.
std::vector<CheckCase> read_check_folder(const std::filesystem::path& folder);

}  // namespace fascia
