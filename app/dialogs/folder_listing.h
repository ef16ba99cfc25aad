// The content of a folder in a dialog: its folders, then the files that can be opened, each sorted by name, ignoring
// case.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace fascia {

struct FileKind {
  const char* name;
  std::vector<std::string> endings;  // lower case, with the dot; for TetGen's pairs the .node file
};
/// First all kinds together, then each kind.
const std::vector<FileKind>& openable_kinds();

struct FolderEntry {
  std::filesystem::path path;
  bool is_folder = false;
};

/// Hidden entries are left out. `part`: only names that contain it, ignoring case. Empty for a folder that cannot be
/// read.
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder, const FileKind& kind,
                                     const std::string& part = "");

}  // namespace fascia
