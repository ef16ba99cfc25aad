#include "app/cli/output_files.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/cli/usage_error.h"
#include "base/file.h"
#include "sim/mesh/io/mesh_formats.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;

// Extensions that identify a kind of file, beside those of meshes. Others, such as .txt, .log or none, do not.
constexpr auto kKinds = std::to_array<std::string_view>(
    {".png", ".jpg", ".jpeg", ".gif", ".bmp",  ".tif", ".tiff", ".webp", ".svg",   ".ppm", ".tga",  // pictures
     ".mp4", ".m4v", ".mov",  ".mkv", ".webm", ".avi", ".ogv",  ".mpg",  ".mpeg",  ".wmv", ".flv",  // videos
     ".csv", ".pvd", ".json", ".xml", ".html", ".pdf", ".zip",  ".gz",   ".fascia"});

bool has_kind(const std::string& ending) {
  const auto among = [&](const auto& endings) {
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
  };
  return among(kKinds) || among(tet_endings()) || among(surface_endings());
}

bool is_special(const fs::path& path) {
  std::error_code ec;
  return fs::exists(path, ec) && !fs::is_regular_file(path, ec);
}

// Also detects other names, links and paths. Devices accept any output; standard output accepts one.
bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code ec;
  if (a == kStandardOutput || b == kStandardOutput) return a == b;
  if (is_special(a)) return false;
  if (fs::equivalent(a, b, ec)) return true;
  const fs::path whole_a = fs::weakly_canonical(link_target(a), ec), whole_b = fs::weakly_canonical(link_target(b), ec);
  return !whole_a.empty() && whole_a == whole_b;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

void require_ending(const OutputFile& output) {
  const std::string ending = lower_ending(output.path);
  const auto& endings = output.endings;
  if (endings.empty() || output.path == kStandardOutput || is_special(output.path)) return;
  if (std::find(endings.begin(), endings.end(), ending) != endings.end()) return;
  const bool any = output.takes == OutputFile::Takes::all_but_foreign;
  if (any && !has_kind(ending)) return;
  throw UsageError(output.option + " " + output.path,
                   ending.empty() ? "has no ending that names its format" : "cannot be written as " + ending,
                   "expected " + listed(endings));
}

}  // namespace

void require_outputs(const std::vector<OutputFile>& outputs, const std::vector<fs::path>& inputs) {
  for (const OutputFile& output : outputs)
    if (!output.path.empty()) require_ending(output);
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->path.empty()) continue;
    for (auto other = outputs.begin(); other != output; ++other)
      if (!other->path.empty() && same_file(output->path, other->path))
        throw UsageError(output->option + " " + output->path, "is the file of " + other->option,
                         "expected another one");
    for (const fs::path& input : inputs)
      if (!input.empty() && same_file(output->path, input))
        throw UsageError(output->option + " " + output->path, "is a file that is read", "expected another one");
    require_writable(output->path);
  }
}

}  // namespace fascia
