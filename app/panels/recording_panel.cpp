// The settings of videos of the window, and the session as a file.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "app/ui/widgets.h"

namespace fascia {
namespace {

struct Size {
  const char* label;
  int width, height;
};
constexpr std::array<Size, 4> kSizes{
    {{"Window", 0, 0}, {"720p", 1280, 720}, {"1080p", 1920, 1080}, {"4K", 3840, 2160}}};
constexpr std::array<std::pair<const char*, VideoKind>, 3> kKinds{
    {{"MP4", VideoKind::mp4}, {"WebM", VideoKind::webm}, {"PNGs", VideoKind::pictures}}};
constexpr int kLeastPixels = 16, kMostPixels = 16384;  // the limits of --size
constexpr std::array<double, 3> kRates{24, 30, 60};

void label(const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(ui::kDim, "%s", text);
  ImGui::SameLine(ui::px(84));
}

// The resulting size, which can be edited.
void size_fields(VideoSettings& video) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const VideoSettings::Size size = video.size_in({static_cast<int>(window.x), static_cast<int>(window.y)});
  int shown[2] = {size.width, size.height};
  ImGui::SetNextItemWidth(ui::px(140));
  if (ImGui::InputInt2("##pixels", shown)) {
    video.width = std::clamp(shown[0], kLeastPixels, kMostPixels);
    video.height = std::clamp(shown[1], kLeastPixels, kMostPixels);
  }
  ui::tooltip(
      "Width and height of videos and pictures, independent of the size of the window. Both are even for videos");
}

}  // namespace

void draw_recording_settings(WindowState& state, Requests& requests) {
  ImGui::SetNextWindowPos({panel_width() + ui::px(24), ui::px(100)}, ImGuiCond_Appearing);
  if (ImGui::Begin("Recording", &state.show_recording,
                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                       ImGuiWindowFlags_AlwaysAutoResize)) {
    ui::keep_inside();
    VideoSettings& video = state.video;
    ImGui::BeginDisabled(state.recording);
    label("File");
    for (const auto& [name, kind] : kKinds) {
      if (ui::button(name, ui::px(66), video.kind == kind)) video.kind = kind;
      ImGui::SameLine();
    }
    ImGui::NewLine();
    label("Size");
    for (const Size& size : kSizes) {
      if (ui::button(size.label, ui::px(66),
                     video.width == size.width && (video.height == size.height || size.width == 0))) {
        video.width = size.width;
        video.height = size.height;
      }
      ImGui::SameLine();
    }
    ImGui::NewLine();
    label("Pixels");
    size_fields(video);
    label("Frames/s");
    for (const double rate : kRates) {
      char text[8];
      std::snprintf(text, sizeof text, "%.0f", rate);
      if (ui::button(text, ui::px(66), video.fps == rate)) video.fps = rate;
      ImGui::SameLine();
    }
    ImGui::NewLine();
    label("Panels");
    if (ui::button(video.panels ? "In the video" : "Left out", ui::px(140), video.panels)) video.panels = !video.panels;
    ImGui::EndDisabled();
    requests.video |= ui::button(state.recording ? "Stop video (V)" : "Record video (V)", ui::px(180), state.recording);
    ImGui::Separator();
    requests.save_replay_dialog |= ui::button("Save replay... (Ctrl+R)", ui::px(180), false);
    ui::tooltip(
        "All inputs to this scene since it was opened, or since its regions or sides changed, as a small file that "
        "repeats the session to the bit");
  }
  ImGui::End();
}

}  // namespace fascia
