#include "sim/mesh/io/fem/included_files.h"

#include <algorithm>

namespace fascia {

Scanner& IncludedFiles::open(const Scanner& in, const std::string& name) {
  constexpr std::size_t kMostFiles = 32;
  const bool printable = std::none_of(name.begin(), name.end(), [](unsigned char c) { return c < ' '; });
  if (name.empty() || !printable) in.fail("names " + in_quotes(name), "expected the name of a file");
  if (files_.size() == kMostFiles)
    in.fail("is one included file too many", "expected at most " + std::to_string(kMostFiles));
  const std::filesystem::path path = std::filesystem::path(root_).parent_path() / name;
  files_.push_back(std::make_unique<File>(path.string(), read_beside_(name)));
  return files_.back()->in;
}

}  // namespace fascia
