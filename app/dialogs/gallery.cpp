#include "app/dialogs/gallery.h"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "app/ui/style.h"
#include "base/file.h"
#include "render/target/image.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

constexpr const char* kGalleryTitle = "Examples";
constexpr float kPictureWidth = 224, kPictureHeight = 126;  // of a picture [points]

}  // namespace

std::vector<Example> shipped_examples(const fs::path& assets) {
  std::vector<Example> examples;
  std::error_code ec;
  for (fs::directory_iterator it(assets / "scenes", ec), end; !ec && it != end; it.increment(ec)) {
    if (it->path().extension() != ".json") continue;
    const fs::path stem = it->path().stem();
    try {
      const auto scene = nlohmann::json::parse(read_file(it->path()));
      examples.push_back({it->path(), assets / "pictures" / "scenes" / (stem.string() + ".png"),
                          scene.value("title", stem.string()), ""});
    } catch (const std::exception&) {
      continue;
    }
  }
  std::sort(examples.begin(), examples.end(), [](const Example& a, const Example& b) { return a.scene < b.scene; });
  try {
    auto next = examples.begin();
    for (const auto& entry : nlohmann::json::parse(read_file(assets / "gallery.json"))) {
      const auto named = std::find_if(next, examples.end(), [&](const Example& e) {
        return e.scene.stem() == entry.at("scene").get<std::string>();
      });
      if (named == examples.end()) continue;
      named->says = entry.at("says").get<std::string>();
      std::rotate(next, named, named + 1);
      ++next;
    }
  } catch (const std::exception&) {
    return examples;  // in the order of their names
  }
  return examples;
}

void Gallery::load() {
  examples_ = shipped_examples(assets_);
  pictures_.clear();
  for (const Example& example : examples_) {
    try {
      const Image image = read_png(example.picture);
      pictures_.emplace_back("example picture", GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                             image.rgba.data());
    } catch (const std::exception&) {
      pictures_.emplace_back();
    }
  }
}

bool Gallery::draw(Requests& requests) {
  if (!open_) pictures_.clear();  // not in the closing frame, which still draws them
  if (start_) {
    load();
    ImGui::OpenPopup(kGalleryTitle);
    open_ = true;
    start_ = false;
  }
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {screen.x, 0.94f * screen.y});
  bool stays = true;
  if (ImGui::BeginPopupModal(
          kGalleryTitle, &stays,
          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove)) {
    const ImVec2 size{ui::px(kPictureWidth), ui::px(kPictureHeight)};
    const int columns = std::clamp(static_cast<int>((screen.x - ui::px(60)) / (size.x + ui::px(28))), 1, 3);
    if (ImGui::BeginTable("examples", columns)) {
      for (std::size_t i = 0; i < examples_.size(); ++i) {
        ImGui::TableNextColumn();
        ImGui::PushID(static_cast<int>(i));
        const auto picture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(pictures_[i].id()));
        const bool chosen = pictures_[i].id()
                                ? ImGui::ImageButton(picture, size, {0, 0}, {1, 1}, static_cast<int>(ui::px(4)))
                                : ImGui::Button(examples_[i].title.c_str(), {size.x + ui::px(8), size.y + ui::px(8)});
        if (chosen) requests.open = examples_[i].scene;
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + size.x + ui::px(8));
        ImGui::PushFont(ui::bold_font());
        ImGui::TextWrapped("%s", examples_[i].title.c_str());
        ImGui::PopFont();
        ImGui::TextColored(ui::kDim, "%s", examples_[i].says.c_str());
        ImGui::PopTextWrapPos();
        ImGui::Spacing();
        ImGui::PopID();
      }
      ImGui::EndTable();
    }
    if (requests.open || !stays || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  const bool closed = open_ && !ImGui::IsPopupOpen(kGalleryTitle);
  if (closed) open_ = false;
  return closed;
}

}  // namespace fascia
