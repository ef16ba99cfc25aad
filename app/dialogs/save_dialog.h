// Asks for the path of a file to save: a name, and a folder. An existing file is replaced only after confirmation.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/dialogs/folder_browser.h"

namespace fascia {

class SaveDialog {
 public:
  struct Format {
    std::string ending, help;
  };
  using Shipped = std::function<bool(const std::filesystem::path&)>;  // whether a file was shipped with fascia
  struct Option {
    std::string label, help;  // empty label: no option
  };
  /// The extension of the name selects one of several formats; a name without an extension gets the first. `option`: a
  /// check box, initially off.
  SaveDialog(const char* title, std::vector<Format> formats, Option option = {});

  /// Opens with this name, at first in the working folder, later in the folder of the last save.
  void ask(const std::string& name);
  /// Call between ImGui::NewFrame and ImGui::Render. `places`: in addition to the usual ones.
  std::optional<std::filesystem::path> draw(const std::vector<Place>& places, const Shipped& shipped);
  bool option() const { return option_on_; }  // whether the check box is on

 private:
  void go_to(const std::filesystem::path& folder);
  void choose();
  void choose_format();
  void question(const Shipped& shipped);
  bool known(const std::string& ending) const;

  const char* title_;
  std::vector<Format> formats_;
  Option option_;
  bool option_on_ = false;
  FileKind kind_;
  FolderBrowser browser_;
  std::string name_, walked_from_;  // walked_from_: the name before the arrow keys changed it
  std::string warning_;
  std::filesystem::path target_;
  enum class Stage { closed, asked, open, questioned, done } stage_ = Stage::closed;
  bool focus_ = false;
};

}  // namespace fascia
