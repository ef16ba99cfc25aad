#include "app/output_files.h"

#include <algorithm>

#include "app/usage_error.h"
#include "sim/file.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;

// Also by other names, links and paths. Devices take what comes.
bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code ec;
  if (fs::exists(a, ec) && !fs::is_regular_file(a, ec)) return false;
  if (fs::equivalent(a, b, ec)) return true;
  const fs::path whole_a = fs::weakly_canonical(a, ec), whole_b = fs::weakly_canonical(b, ec);
  return !whole_a.empty() && whole_a == whole_b;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

}  // namespace

void require_outputs(const std::vector<OutputFile>& outputs, const std::vector<fs::path>& inputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->path.empty()) continue;
    std::error_code ec;
    const bool device = fs::exists(output->path, ec) && !fs::is_regular_file(output->path, ec);
    const auto& endings = output->endings;
    if (!endings.empty() && !device && std::find(endings.begin(), endings.end(), lower_ending(output->path)) == endings.end())
      throw UsageError(output->option + " " + output->path, "has an ending that it cannot write", "expected " + listed(endings));
    for (auto other = outputs.begin(); other != output; ++other)
      if (!other->path.empty() && same_file(output->path, other->path))
        throw UsageError(output->option + " " + output->path, "is the file of " + other->option, "expected another one");
    for (const fs::path& input : inputs)
      if (!input.empty() && same_file(output->path, input))
        throw UsageError(output->option + " " + output->path, "is a file that is read", "expected another one");
    require_writable(output->path);
  }
}

}  // namespace fascia
