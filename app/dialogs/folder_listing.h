// What a dialog shows of a folder: its folders, then the files that can be opened, each sorted by name, without case.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace fascia {

struct FileKind {
  const char* name;
  std::vector<std::string> endings;  // lower case, with the dot; of TetGen's pairs the .node file
};
/// All first, then by what they are.
const std::vector<FileKind>& openable_kinds();

struct FolderEntry {
  std::filesystem::path path;
  bool is_folder = false;
};

/// Hidden ones are left out. `part`: only names that have it, whatever the case. Nothing for a folder that cannot be
/// read.
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder, const FileKind& kind,
                                     const std::string& part = "");

}  // namespace fascia
