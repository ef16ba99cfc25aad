#include "app/ui/style.h"

#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>

namespace fascia::ui {
namespace {

// fontconfig's default on Debian, installed wherever ffmpeg is; without it ImGui's own bitmap font is used.
constexpr const char* kFontFolders[] = {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/TTF",
                                        "/usr/share/fonts/dejavu-sans-fonts"};

float style_scale = 1, user_scale = 1;
ImFont *heading_font = nullptr, *font_of_legend = nullptr;

ImFont* load_font(const char* file, float size) {
  for (const char* folder : kFontFolders) {
    const std::filesystem::path path = std::filesystem::path(folder) / file;
    std::error_code ec;
    if (std::filesystem::is_regular_file(path, ec))
      return ImGui::GetIO().Fonts->AddFontFromFileTTF(path.c_str(), size, nullptr,
                                                      ImGui::GetIO().Fonts->GetGlyphRangesDefault());
  }
  return nullptr;
}

void load_fonts(float scale, float legend_font_size) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  const auto pixels = [&](float points) { return static_cast<float>(static_cast<int>(points * scale + 0.5f)); };
  const float size = pixels(kFontSize);
  heading_font = font_of_legend = nullptr;
  if (load_font("DejaVuSans.ttf", size)) heading_font = load_font("DejaVuSans-Bold.ttf", size);
  if (io.Fonts->Fonts.empty()) {
    ImFontConfig config;
    config.SizePixels = 13.0f * static_cast<float>(scale < 1.5f ? 1 : static_cast<int>(scale + 0.5f));
    io.Fonts->AddFontDefault(&config);
  }
  if (!heading_font) heading_font = io.Fonts->Fonts[0];
  if (legend_font_size != kFontSize) font_of_legend = load_font("DejaVuSans.ttf", pixels(legend_font_size));
  if (!font_of_legend) font_of_legend = io.Fonts->Fonts[0];
}

struct Palette {
  ImVec4 accent, text, dim, good, warning, danger, panel;
  ImVec4 frame, frame_hovered, frame_active, title, tab;
  float shade;  // 1: marks on panels are white, 0: black; their strength is the same
};
const Palette kDark{{0.91f, 0.47f, 0.38f, 1},
                    {0.91f, 0.92f, 0.93f, 1},
                    {0.62f, 0.65f, 0.69f, 1},
                    {0.45f, 0.80f, 0.45f, 1},
                    {0.97f, 0.76f, 0.36f, 1},
                    {0.95f, 0.30f, 0.26f, 1},
                    {0.085f, 0.095f, 0.11f, 0.93f},
                    {0.17f, 0.185f, 0.21f, 1},
                    {0.22f, 0.24f, 0.27f, 1},
                    {0.26f, 0.28f, 0.32f, 1},
                    {0.12f, 0.13f, 0.15f, 1},
                    {0.42f, 0.25f, 0.22f, 1},
                    1};
const Palette kLight{{0.78f, 0.29f, 0.20f, 1},
                     {0.10f, 0.11f, 0.13f, 1},
                     {0.38f, 0.41f, 0.45f, 1},
                     {0.10f, 0.45f, 0.14f, 1},
                     {0.62f, 0.40f, 0.02f, 1},
                     {0.75f, 0.10f, 0.08f, 1},
                     {0.965f, 0.97f, 0.975f, 0.95f},
                     {0.885f, 0.895f, 0.91f, 1},
                     {0.84f, 0.855f, 0.875f, 1},
                     {0.79f, 0.81f, 0.84f, 1},
                     {0.91f, 0.92f, 0.93f, 1},
                     {0.96f, 0.79f, 0.74f, 1},
                     0};

Theme chosen = Theme::dark;
Palette now = kDark;

ImVec4 with_alpha(ImVec4 color, float alpha) { return {color.x, color.y, color.z, alpha}; }

ImVec4 mark(float strength) { return {now.shade, now.shade, now.shade, strength}; }

void set_colors(ImGuiStyle& style) {
  ImVec4* colors = style.Colors;
  if (chosen == Theme::dark)
    ImGui::StyleColorsDark(&style);
  else
    ImGui::StyleColorsLight(&style);
  colors[ImGuiCol_Text] = kText;
  colors[ImGuiCol_TextDisabled] = kDim;
  colors[ImGuiCol_WindowBg] = kPanel;
  colors[ImGuiCol_PopupBg] = with_alpha(kPanel, 0.98f);
  colors[ImGuiCol_Border] = mark(0.10f);
  colors[ImGuiCol_FrameBg] = now.frame;
  colors[ImGuiCol_FrameBgHovered] = now.frame_hovered;
  colors[ImGuiCol_FrameBgActive] = now.frame_active;
  colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = colors[ImGuiCol_TitleBgCollapsed] = now.title;
  colors[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
  colors[ImGuiCol_ScrollbarGrab] = mark(0.14f);
  colors[ImGuiCol_ScrollbarGrabHovered] = mark(0.22f);
  colors[ImGuiCol_ScrollbarGrabActive] = mark(0.30f);
  colors[ImGuiCol_CheckMark] = kAccent;
  colors[ImGuiCol_SliderGrab] = with_alpha(kAccent, 0.85f);
  colors[ImGuiCol_SliderGrabActive] = kAccent;
  colors[ImGuiCol_Button] = now.frame;
  colors[ImGuiCol_ButtonHovered] = now.frame_hovered;
  colors[ImGuiCol_ButtonActive] = now.frame_active;
  colors[ImGuiCol_Header] = mark(0.06f);
  colors[ImGuiCol_HeaderHovered] = mark(0.10f);
  colors[ImGuiCol_HeaderActive] = mark(0.14f);
  colors[ImGuiCol_Separator] = mark(0.08f);
  colors[ImGuiCol_Tab] = colors[ImGuiCol_TabUnfocused] = now.frame;
  colors[ImGuiCol_TabHovered] = now.frame_active;
  colors[ImGuiCol_TabActive] = colors[ImGuiCol_TabUnfocusedActive] = now.tab;
  colors[ImGuiCol_PlotLines] = kAccent;
  colors[ImGuiCol_PlotHistogram] = kAccent;
  colors[ImGuiCol_TextSelectedBg] = with_alpha(kAccent, 0.35f);
  colors[ImGuiCol_NavHighlight] = kAccent;
  colors[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, 0.45f};
}

}  // namespace

const ImVec4 &kAccent = now.accent, &kText = now.text, &kDim = now.dim, &kGood = now.good, &kWarning = now.warning,
             &kDanger = now.danger, &kPanel = now.panel;

void set_interface_scale(float factor) { user_scale = std::clamp(factor, kLeastScale, kLargestScale); }
float interface_scale() { return user_scale; }

float px(float points) { return points * style_scale; }
ImFont* bold_font() { return heading_font; }
ImFont* legend_font() { return font_of_legend; }

Theme theme() { return chosen; }

void set_theme(Theme wanted) {
  chosen = wanted;
  now = wanted == Theme::dark ? kDark : kLight;
  set_colors(ImGui::GetStyle());
}

void apply_style(float scale, float legend_font_size) {
  style_scale = scale;
  load_fonts(scale, legend_font_size);
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

  set_colors(style);
  style.ScaleAllSizes(scale);
  style.PopupBorderSize = 1;
  ImGui::GetStyle() = style;
}

}  // namespace fascia::ui
