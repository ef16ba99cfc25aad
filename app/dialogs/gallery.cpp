#include "app/dialogs/gallery.h"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/ui/style.h"
#include "app/ui/widgets.h"
#include "base/file.h"
#include "render/target/image.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

constexpr const char* kGalleryTitle = "Examples";
constexpr float kPictureWidth = 112, kPictureHeight = 63, kMargin = 10;  // of a picture, of the strip [points]

}  // namespace

std::vector<Example> shipped_examples(const fs::path& assets) {
  std::vector<Example> examples;
  std::error_code ec;
  for (fs::directory_iterator it(assets / "scenes", ec), end; !ec && it != end; it.increment(ec)) {
    if (it->path().extension() != ".json") continue;
    const fs::path stem = it->path().stem();
    try {
      const auto scene = nlohmann::json::parse(read_file(it->path()));
      examples.push_back({it->path(), assets / "pictures" / "scenes" / (stem.string() + ".png"), stem.string(),
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
      named->name = entry.at("name").get<std::string>();
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

void Gallery::draw_example(std::size_t index, WindowState& state, Requests& requests) const {
  const Example& example = examples_[index];
  const ImVec2 size{ui::px(kPictureWidth), ui::px(kPictureHeight)};
  const float frame = ui::px(3), width = size.x + 2 * frame;
  ImGui::PushID(static_cast<int>(index));
  ImGui::BeginGroup();
  const auto picture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(pictures_[index].id()));
  const bool chosen = pictures_[index].id() ? ImGui::ImageButton(picture, size, {0, 0}, {1, 1}, static_cast<int>(frame))
                                            : ImGui::Button("##example", {width, size.y + 2 * frame});
  const ImVec2 at = ImGui::GetCursorScreenPos();  // a name that is too long is cut off
  const ImVec4 clip{at.x, at.y, at.x + width, at.y + ImGui::GetTextLineHeight()};
  ImGui::GetWindowDrawList()->AddText(nullptr, 0, at, ImGui::GetColorU32(ui::kText), example.name.c_str(), nullptr, 0,
                                      &clip);
  ImGui::Dummy({width, ImGui::GetTextLineHeight()});
  ImGui::EndGroup();
  ui::tooltip(example.title + (example.says.empty() ? "" : "\n" + example.says));
  ImGui::PopID();
  if (!chosen) return;
  requests.open = example.scene;
  state.show_gallery = false;
}

bool Gallery::draw(WindowState& state, float left, Requests& requests) {
  if (!open_) pictures_.clear();  // not in the closing frame, which still draws them
  const bool shown = state.show_gallery;
  if (shown && !open_) load();
  if (shown) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float margin = ui::px(kMargin), begin = std::max(left, margin), pad = ui::px(8),
                height = ImGui::GetFrameHeight() + 2 * pad + ui::px(kPictureHeight + 6) + style.ItemSpacing.y +
                         ImGui::GetTextLineHeight() + style.ScrollbarSize;
    ImGui::SetNextWindowPos({begin, screen.y - margin - height});
    ImGui::SetNextWindowSize({std::max(1.0f, screen.x - begin - margin), height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
    if (ImGui::Begin(kGalleryTitle, &state.show_gallery,
                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                         ImGuiWindowFlags_HorizontalScrollbar)) {
      for (std::size_t i = 0; i < examples_.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        draw_example(i, state, requests);
      }
      if (ImGui::IsWindowHovered() && ImGui::GetIO().MouseWheel != 0)  // the strip has no other direction
        ImGui::SetScrollX(ImGui::GetScrollX() - ui::px(60) * ImGui::GetIO().MouseWheel);
    }
    ImGui::End();
    ImGui::PopStyleVar();
    state.gallery_height = height + margin;
  } else {
    state.gallery_height = 0;
  }
  return std::exchange(open_, state.show_gallery) && !open_;
}

}  // namespace fascia
