#include "app/dialogs/save_dialog.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/dialogs/dialog.h"
#include "app/ui/style.h"
#include "base/file.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

constexpr const char* kQuestion = "Replace the file?";

}  // namespace

SaveDialog::SaveDialog(const char* title, std::vector<Format> formats, Option option)
    : title_(title), formats_(std::move(formats)), option_(std::move(option)), kind_{title, {}} {
  for (const Format& format : formats_) kind_.endings.push_back(format.ending);
}

bool SaveDialog::known(const std::string& ending) const {
  return std::find(kind_.endings.begin(), kind_.endings.end(), ending) != kind_.endings.end();
}

void SaveDialog::ask(const std::string& name) {
  name_ = name;
  go_to(browser_.folder().empty() ? started_folder() : fs::path(browser_.folder()));
  stage_ = Stage::asked;
}

void SaveDialog::go_to(const fs::path& folder) {
  browser_.go_to(folder, kind_);
  warning_.clear();
  focus_ = true;
}

// The action of Enter and the button: open a folder, or accept the name.
void SaveDialog::choose() {
  std::error_code ec;
  const FolderEntry* marked = browser_.marked();
  if (marked && marked->is_folder) return go_to(fs::path(marked->path));
  if (marked) name_ = marked->path.filename().string();
  if (name_.empty()) return;
  target_ = (name_.starts_with("~/") ? home_folder() / name_.substr(2) : browser_.folder() / name_).lexically_normal();
  if (fs::is_directory(target_, ec)) {
    name_.clear();
    return go_to(fs::path(target_));
  }
  if (!target_.has_extension()) target_ += formats_.front().ending;
  focus_ = true;
  if (!fs::is_directory(target_.parent_path(), ec)) {
    warning_ = "There is no folder " + target_.parent_path().string();
  } else if (!known(lower_ending(target_))) {
    warning_ = "Expected a name that ends in";
    for (const Format& format : formats_) warning_ += " " + format.ending;
  } else {
    warning_.clear();
    stage_ = fs::exists(target_, ec) ? Stage::questioned : Stage::done;
  }
}

void SaveDialog::choose_format() {
  const fs::path name = name_;
  const std::string ending = lower_ending(name);
  for (const Format& format : formats_) {
    if (&format != &formats_.front()) ImGui::SameLine();
    if (ImGui::RadioButton(format.ending.c_str(), ending == format.ending))
      name_ = fs::path(name).replace_extension(format.ending).string();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", format.help.c_str());
  }
}

// Enter must not replace a file: the first button goes back.
void SaveDialog::question(const Shipped& shipped) {
  if (!begin_dialog(kQuestion)) return;
  ImGui::PushTextWrapPos(ui::px(420));
  ImGui::Text("%s is in the folder %s already.", target_.filename().c_str(), target_.parent_path().c_str());
  if (shipped(target_)) ImGui::TextColored(ui::kWarning, "It came with fascia.");
  ImGui::PopTextWrapPos();
  const bool back = dialog_button("Back") || escape_pressed();
  ImGui::SetItemDefaultFocus();
  ImGui::SameLine();
  const bool replace = dialog_button("Replace");
  if (back || replace) {
    stage_ = replace ? Stage::done : Stage::open;
    focus_ = true;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

std::optional<fs::path> SaveDialog::draw(const std::vector<Place>& places, const Shipped& shipped) {
  if (stage_ == Stage::asked) {
    ImGui::OpenPopup(title_);
    stage_ = Stage::open;
  }
  if (!begin_dialog(title_)) return {};
  const bool questioned = stage_ == Stage::questioned;
  ImGui::TextColored(ui::kDim, "%s", browser_.folder().c_str());
  bool chosen = name_field(name_, FolderBrowser::width(), !questioned && std::exchange(focus_, false));
  if (!questioned) browser_.walk_by_keys();
  if (name_ != walked_from_) {
    walked_from_ = name_;
    browser_.unmark();
  }
  std::vector<Place> all{{"Started in", started_folder()}, {"Home", home_folder()}, {"Computer", "/"}};
  all.insert(all.end(), places.begin(), places.end());
  if (const auto clicked = browser_.draw(all)) {
    if (clicked->is_folder) {
      go_to(clicked->path);
    } else {
      name_ = walked_from_ = clicked->path.filename().string();
      focus_ = true;
    }
  }
  if (formats_.size() > 1) choose_format();
  if (!option_.label.empty()) {
    ImGui::Checkbox(option_.label.c_str(), &option_on_);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", option_.help.c_str());
  }
  if (!warning_.empty()) ImGui::TextColored(ui::kWarning, "%s", warning_.c_str());
  chosen |= dialog_button("Save");
  ImGui::SameLine();
  const bool cancel = dialog_button("Cancel") || (escape_pressed() && !questioned);
  if (chosen && !cancel) choose();
  if (stage_ == Stage::questioned) {
    if (!questioned) ImGui::OpenPopup(kQuestion);
    question(shipped);
  }
  const bool done = stage_ == Stage::done;
  if (done || cancel) {
    stage_ = Stage::closed;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  return done ? std::optional(target_) : std::nullopt;
}

}  // namespace fascia
