#include "app/ui_style.h"

#include <imgui.h>

#include <filesystem>
#include <initializer_list>

namespace fascia::ui {
namespace {

constexpr float kFontSize = 14.5f;  // at scale 1

// fontconfig's default on Debian, so it is there wherever ffmpeg is; without it ImGui's own bitmap font serves.
constexpr const char* kFontFolders[] = {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/TTF",
                                        "/usr/share/fonts/dejavu-sans-fonts"};

float style_scale = 1;
ImFont* heading_font = nullptr;

ImFont* load_font(const char* file, float size) {
  for (const char* folder : kFontFolders) {
    const std::filesystem::path path = std::filesystem::path(folder) / file;
    std::error_code ec;
    if (std::filesystem::is_regular_file(path, ec))
      return ImGui::GetIO().Fonts->AddFontFromFileTTF(path.c_str(), size, nullptr, ImGui::GetIO().Fonts->GetGlyphRangesDefault());
  }
  return nullptr;
}

void load_fonts(float scale) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  const float size = static_cast<float>(static_cast<int>(kFontSize * scale + 0.5f));
  heading_font = nullptr;
  if (load_font("DejaVuSans.ttf", size)) heading_font = load_font("DejaVuSans-Bold.ttf", size);
  if (io.Fonts->Fonts.empty()) {
    ImFontConfig config;
    config.SizePixels = 13.0f * static_cast<float>(scale < 1.5f ? 1 : static_cast<int>(scale + 0.5f));
    io.Fonts->AddFontDefault(&config);
  }
  if (!heading_font) heading_font = io.Fonts->Fonts[0];
}

ImVec4 with_alpha(ImVec4 color, float alpha) { return {color.x, color.y, color.z, alpha}; }

}  // namespace

const ImVec4 kAccent{0.91f, 0.47f, 0.38f, 1}, kText{0.91f, 0.92f, 0.93f, 1}, kDim{0.62f, 0.65f, 0.69f, 1},
    kWarning{0.97f, 0.76f, 0.36f, 1}, kDanger{0.95f, 0.30f, 0.26f, 1}, kPanel{0.085f, 0.095f, 0.11f, 0.93f};

float px(float points) { return points * style_scale; }
ImFont* bold_font() { return heading_font; }

void apply_style(float scale) {
  style_scale = scale;
  load_fonts(scale);
  ImGuiStyle style;
  style.WindowPadding = {14, 12};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.ScrollbarSize = 10;
  style.GrabMinSize = 10;
  style.WindowRounding = style.PopupRounding = 8;
  style.FrameRounding = style.GrabRounding = style.TabRounding = 5;
  style.ScrollbarRounding = 5;
  style.WindowBorderSize = style.FrameBorderSize = style.TabBorderSize = 0;
  style.PopupBorderSize = 1;
  style.WindowTitleAlign = {0.5f, 0.5f};

  const ImVec4 frame{0.17f, 0.185f, 0.21f, 1}, frame_hovered{0.22f, 0.24f, 0.27f, 1}, frame_active{0.26f, 0.28f, 0.32f, 1};
  ImVec4* colors = style.Colors;
  ImGui::StyleColorsDark(&style);
  colors[ImGuiCol_Text] = kText;
  colors[ImGuiCol_TextDisabled] = kDim;
  colors[ImGuiCol_WindowBg] = kPanel;
  colors[ImGuiCol_PopupBg] = with_alpha(kPanel, 0.98f);
  colors[ImGuiCol_Border] = {1, 1, 1, 0.10f};
  colors[ImGuiCol_FrameBg] = frame;
  colors[ImGuiCol_FrameBgHovered] = frame_hovered;
  colors[ImGuiCol_FrameBgActive] = frame_active;
  colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = colors[ImGuiCol_TitleBgCollapsed] = {0.12f, 0.13f, 0.15f, 1};
  colors[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
  colors[ImGuiCol_ScrollbarGrab] = {1, 1, 1, 0.14f};
  colors[ImGuiCol_ScrollbarGrabHovered] = {1, 1, 1, 0.22f};
  colors[ImGuiCol_ScrollbarGrabActive] = {1, 1, 1, 0.30f};
  colors[ImGuiCol_CheckMark] = kAccent;
  colors[ImGuiCol_SliderGrab] = with_alpha(kAccent, 0.85f);
  colors[ImGuiCol_SliderGrabActive] = kAccent;
  colors[ImGuiCol_Button] = frame;
  colors[ImGuiCol_ButtonHovered] = frame_hovered;
  colors[ImGuiCol_ButtonActive] = frame_active;
  colors[ImGuiCol_Header] = {1, 1, 1, 0.06f};
  colors[ImGuiCol_HeaderHovered] = {1, 1, 1, 0.10f};
  colors[ImGuiCol_HeaderActive] = {1, 1, 1, 0.14f};
  colors[ImGuiCol_Separator] = {1, 1, 1, 0.08f};
  colors[ImGuiCol_Tab] = colors[ImGuiCol_TabUnfocused] = frame;
  colors[ImGuiCol_TabHovered] = frame_active;
  colors[ImGuiCol_TabActive] = colors[ImGuiCol_TabUnfocusedActive] = {0.42f, 0.25f, 0.22f, 1};
  colors[ImGuiCol_PlotLines] = kAccent;
  colors[ImGuiCol_PlotHistogram] = kAccent;
  colors[ImGuiCol_TextSelectedBg] = with_alpha(kAccent, 0.35f);
  colors[ImGuiCol_NavHighlight] = kAccent;
  colors[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, 0.45f};
  style.ScaleAllSizes(scale);
  style.PopupBorderSize = 1;
  ImGui::GetStyle() = style;
}

}  // namespace fascia::ui
