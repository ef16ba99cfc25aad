#include "app/overlay/overlay.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "app/overlay/color_bar.h"
#include "app/panels/panels.h"
#include "app/session/framing.h"
#include "app/ui/style.h"
#include "app/ui/widgets.h"
#include "app/ui/window_input.h"

namespace fascia {

Overlay::Overlay(Graphics& graphics) : graphics_(graphics) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  if (GLFWwindow* window = graphics.context->window()) {
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui_ImplGlfw_InitForOther(window,
                                false);  // WindowInput receives events first and calls its callbacks
  }
}

Overlay::~Overlay() {
  renderer_.reset();
  if (graphics_.context->window()) ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void Overlay::set_scale(float scale) {
  if (scale == scale_ && legend_font_ == loaded_legend_font_) return;
  scale_ = scale;
  loaded_legend_font_ = legend_font_;
  ui::apply_style(scale, legend_font_);
  renderer_ = std::make_unique<ImguiRenderer>(*graphics_.programs);
}

void Overlay::scale_to(int height) {
  const std::pair before(scale_, loaded_legend_font_);
  set_scale(std::clamp(static_cast<float>(height) / 720, 0.5f, 12.0f));
  if (before == std::pair(scale_, loaded_legend_font_)) return;
  ImGui::GetIO().DisplaySize = {static_cast<float>(height), static_cast<float>(height)};
  ImGui::NewFrame();  // uses the new font
  ImGui::EndFrame();
}

void Overlay::begin(int width, int height) {
  GLFWwindow* window = graphics_.context->window();
  float scale = 1, scale_y = 1;
  glfwGetWindowContentScale(window, &scale, &scale_y);
  set_scale(std::clamp(scale * ui::interface_scale(), 0.5f, 6.0f));
  ImGui_ImplGlfw_NewFrame();
  WindowInput::of(window).feed();  // in pixels of the picture
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.DisplayFramebufferScale = {1, 1};
  ImGui::NewFrame();
}

void Overlay::end() {
  ImGui::ErrorCheckEndFrameRecover(nullptr);  // closes the groups that an exception left open
  ImGui::Render();
}

void Overlay::draw_lists(const Framebuffer& framebuffer, bool foreground) {
  ImDrawData data = *ImGui::GetDrawData();
  const bool has_foreground =
      data.CmdListsCount > 0 && data.CmdLists[data.CmdListsCount - 1] == ImGui::GetForegroundDrawList();
  if (foreground) {
    if (!has_foreground) return;
    data.CmdLists += data.CmdListsCount - 1;
    data.CmdListsCount = 1;
  } else if (has_foreground) {
    --data.CmdListsCount;
  }
  framebuffer.bind_resolved();
  renderer_->draw(data);
}

void Overlay::draw(const Framebuffer& framebuffer) { draw_lists(framebuffer, false); }
void Overlay::draw_foreground(const Framebuffer& framebuffer) { draw_lists(framebuffer, true); }

void Overlay::draw_onto(const Framebuffer& framebuffer, bool panels) {
  ImDrawData data = *ImGui::GetDrawData();
  if (data.CmdListsCount > 0 && data.CmdLists[data.CmdListsCount - 1] == ImGui::GetForegroundDrawList())
    --data.CmdListsCount;
  const bool has_background = data.CmdListsCount > 0 && data.CmdLists[0] == ImGui::GetBackgroundDrawList();
  if (!panels) data.CmdListsCount = has_background ? 1 : 0;
  const float scale = scale_onto(framebuffer);
  data.FramebufferScale = {scale, scale};
  data.DisplaySize = {static_cast<float>(framebuffer.width()) / scale,
                      static_cast<float>(framebuffer.height()) / scale};
  framebuffer.bind_resolved();
  renderer_->draw(data);
}

std::vector<Box> Overlay::covered() const {
  std::vector<Box> boxes = ui::kept_clear();
  for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
    if (window->Active && !window->Hidden && !window->IsFallbackWindow &&
        !(window->Flags & ImGuiWindowFlags_ChildWindow)) {
      const ImRect box = window->Rect();
      boxes.push_back({box.Min.x, box.Min.y, box.Max.x, box.Max.y});
    }
  return boxes;
}

float Overlay::scale_onto(const Framebuffer& framebuffer) const {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  return std::min(static_cast<float>(framebuffer.width()) / size.x, static_cast<float>(framebuffer.height()) / size.y);
}

void Overlay::draw_list(const Framebuffer& framebuffer, float scale, const std::function<void(ImDrawList&)>& paint) {
  const ImVec2 size{static_cast<float>(framebuffer.width()) / scale, static_cast<float>(framebuffer.height()) / scale};
  ImDrawList list(ImGui::GetDrawListSharedData());
  list._ResetForNewFrame();
  list.PushTextureID(ImGui::GetIO().Fonts->TexID);
  list.PushClipRect({0, 0}, size);
  paint(list);
  ImDrawList* lists[] = {&list};
  ImDrawData data;
  data.Valid = true;
  data.CmdLists = lists;
  data.CmdListsCount = 1;
  data.TotalIdxCount = list.IdxBuffer.Size;
  data.TotalVtxCount = list.VtxBuffer.Size;
  data.DisplaySize = size;
  data.FramebufferScale = {scale, scale};
  framebuffer.bind_resolved();
  renderer_->draw(data);
}

void Overlay::draw_headless(Session& session, Framebuffer& framebuffer, bool panels,
                            const std::optional<Diagnostics>& diagnostics, const std::vector<GrabMark>& grabs,
                            const std::function<void()>& more) {
  set_legend_font(session.display().legend.font_size);
  scale_to(framebuffer.height());
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(framebuffer.width()), static_cast<float>(framebuffer.height())};
  io.DeltaTime = 1.0f / 60;
  WindowState state;
  state.facts = SceneFacts(session.simulation.scene, session.simulation.model);
  state.statistics.diagnostics = diagnostics;
  // Twice, since ImGui determines sizes of tables and of auto-sized windows in their second frame.
  for (int pass = 0; pass < 2; ++pass) {
    ImGui::NewFrame();
    Requests nobody_asks;
    if (panels) draw_panels({session, state, nobody_asks});
    const MarkArea area = MarkArea::whole();
    const float left = panels ? panel_space() : 0;
    draw_legend(area, session, left);
    constexpr float kFar = 1e6f;
    LabelPlaces places(framebuffer.height() >= kLeastRows ? area.box() : Box{-kFar, -kFar, kFar, kFar},
                       ui::px(kLabelGap));
    for (const Box& box : covered()) places.keep_clear(box);
    if (const auto legend = legend_box(area.box(), session, left)) places.keep_clear(*legend);
    draw_grab_marks(area, session, grabs, places);
    if (more) more();
    ImGui::Render();
  }
  draw(framebuffer);
}

}  // namespace fascia
