#include "app/dialogs/file_dialogs.h"

#include <imgui.h>

#include <utility>

#include "app/dialogs/dialog.h"
#include "app/session/open_input.h"
#include "app/ui/style.h"
#include "base/dated_name.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

constexpr const char* kOpen = "Open a scene, a mesh or a replay";
constexpr const char* kRecent = "recent files";

}  // namespace

bool FileDialogs::shipped(const fs::path& file) const {
  std::error_code ec;
  const fs::path inside = fs::weakly_canonical(file, ec).lexically_relative(fs::weakly_canonical(assets_, ec));
  return !inside.empty() && *inside.begin() != "..";
}

void FileDialogs::ask_open(const fs::path& open_file) {
  std::error_code ec;
  const fs::path beside = fs::absolute(open_file, ec).parent_path(), before = user_.now().folder;
  if (!browser_.folder().empty())
    go_to(fs::path(browser_.folder()));
  else
    go_to(!open_file.empty() && !shipped(open_file) ? beside
          : fs::is_directory(before, ec)            ? before
                                                    : started_folder());
  if (list_folder(browser_.folder(), openable_kinds()[kind_]).empty()) go_to(assets_ / "scenes");
  start_open_ = true;
}

void FileDialogs::offer_folder_of(const fs::path& scene_file) {
  std::error_code ec;
  scene_folder_ = shipped(scene_file) ? fs::path() : fs::absolute(scene_file, ec).parent_path();
}

void FileDialogs::ask_save(const fs::path& scene_file) {
  offer_folder_of(scene_file);
  scene_.ask(scene_file.stem().string() + ".json");
}

void FileDialogs::ask_export(const fs::path& scene_file) {
  offer_folder_of(scene_file);
  state_.ask(scene_file.stem().string() + ".vtu");
}

void FileDialogs::ask_replay() { replay_.ask(dated_name(".fascia").string()); }
void FileDialogs::ask_recent() { start_recent_ = true; }

void FileDialogs::opened(const fs::path& path) {
  std::error_code ec;
  user_.change([&](UserSettings& settings) {
    settings.opened(path);
    if (!shipped(path)) settings.folder = fs::absolute(path, ec).parent_path().lexically_normal();
  });
}

void FileDialogs::go_to(const fs::path& folder) {
  typed_.clear();
  listed_for_.clear();
  browser_.go_to(folder, openable_kinds()[kind_]);
  focus_ = true;
}

void FileDialogs::recent_files(Requests& requests) {
  for (const fs::path& file : user_.now().recent) {
    std::error_code ec;
    const bool there = fs::exists(file, ec);
    ImGui::PushID(file.c_str());
    if (ImGui::Selectable(file.filename().c_str(), false, there ? 0 : ImGuiSelectableFlags_Disabled))
      requests.open = file;
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
      ImGui::SetTooltip("%s%s", file.c_str(), there ? "" : " (no longer there)");
    ImGui::PopID();
  }
}

fs::path FileDialogs::typed_path() const {
  if (typed_.empty()) return {};
  std::error_code ec;
  const fs::path path = typed_.starts_with("~/") ? home_folder() / typed_.substr(2) : browser_.folder() / typed_;
  // A part of a name that only one file has is accepted as its name, and so is a path relative to the working folder.
  if (!fs::exists(path, ec) && fs::exists(typed_, ec)) return fs::absolute(typed_, ec);
  if (!fs::exists(path, ec) && browser_.entries().size() == 1) return browser_.entries()[0].path;
  return path;
}

void FileDialogs::draw_open(Requests& requests) {
  if (!begin_dialog(kOpen)) return;
  ImGui::TextColored(ui::kDim, "%s", browser_.folder().c_str());
  bool chosen = name_field(typed_, FolderBrowser::width(), std::exchange(focus_, false));
  browser_.walk_by_keys();
  if (typed_ != listed_for_) {  // a part of a name filters the list; a path does not
    listed_for_ = typed_;
    browser_.go_to(fs::path(browser_.folder()), openable_kinds()[kind_],
                   typed_.find('/') == std::string::npos ? typed_ : "");
  }
  const std::vector<Place> places{{"Examples", assets_ / "scenes"},
                                  {"Example meshes", assets_ / "meshes"},
                                  {"Started in", started_folder()},
                                  {"Home", home_folder()},
                                  {"Computer", "/"}};
  const auto clicked = browser_.draw(places, [&] {
    if (!user_.now().recent.empty()) ImGui::TextColored(ui::kDim, "Opened before");
    recent_files(requests);
  });

  ImGui::SetNextItemWidth(FolderBrowser::places_width());
  if (ImGui::BeginCombo("##kind", openable_kinds()[kind_].name)) {
    for (std::size_t i = 0; i < openable_kinds().size(); ++i)
      if (ImGui::Selectable(openable_kinds()[i].name, i == kind_)) {
        kind_ = i;
        go_to(fs::path(browser_.folder()));
      }
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  chosen |= dialog_button("Open");
  ImGui::SameLine();
  const bool cancel = dialog_button("Cancel") || escape_pressed();

  fs::path path;
  if (clicked)
    path = clicked->path;
  else if (chosen)
    path = browser_.marked() ? browser_.marked()->path : typed_path();
  std::error_code ec;
  if (fs::is_directory(path, ec))
    go_to(fs::path(path));
  else if (!path.empty())
    requests.open = path;
  if (requests.open || cancel) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void FileDialogs::draw_recent(Requests& requests) {
  if (!ImGui::BeginPopup(kRecent)) return;
  if (!last_session_.empty()) {
    if (ImGui::MenuItem("Continue where the last window ended")) requests.resume = last_session_;
    ImGui::Separator();
  }
  if (user_.now().recent.empty()) ImGui::TextColored(ui::kDim, "Nothing was opened yet");
  recent_files(requests);
  ImGui::EndPopup();
}

void FileDialogs::draw(Requests& requests) {
  if (std::exchange(start_open_, false)) ImGui::OpenPopup(kOpen);
  if (std::exchange(start_recent_, false)) ImGui::OpenPopup(kRecent);
  draw_open(requests);
  draw_recent(requests);
  std::vector<Place> beside;
  if (!scene_folder_.empty() && scene_folder_ != started_folder())
    beside.push_back({"Beside the scene", scene_folder_});
  const auto came_with = [&](const fs::path& file) { return shipped(file); };
  if (auto path = scene_.draw(beside, came_with)) {
    requests.save = std::move(path);
    requests.save_with_mesh = scene_.option();
  }
  if (auto path = state_.draw(beside, came_with)) requests.export_state = std::move(path);
  if (auto path = replay_.draw(beside, came_with)) requests.save_replay = std::move(path);
}

}  // namespace fascia
