// A folder of scenes whose pictures and states are to stay what they are: its scenes (NAME.json) and replays
// (NAME.fascia), the goldens beside them (NAME.golden.png, NAME.golden.csv), and, where defaults do not do, a strict
// check.json (format: docs/guide/regression.md).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/options.h"

namespace fascia {

struct CheckCase {
  std::string name;       // of the goldens, and of what a failure leaves
  RenderOptions options;  // input, steps, size, goldens, limits
};

/// In the order of their names. Throws Error for a folder without scenes, and as the readers of JSON do.
std::vector<CheckCase> read_check_folder(const std::filesystem::path& folder);

}  // namespace fascia
