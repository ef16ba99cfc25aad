#include "app/window/parts/opening_screen.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>

#include "app/ui/style.h"
#include "app/ui/window_input.h"
#include "gl/loader.h"
#include "render/target/framebuffer.h"

namespace fascia {
namespace {

constexpr double kPatience = 0.2;  // [s]: shorter waits show nothing

}  // namespace

OpeningScreen::OpeningScreen(Graphics& graphics, Overlay& overlay, std::string name)
    : graphics_(graphics), overlay_(overlay), name_(std::move(name)) {}

OpeningScreen::~OpeningScreen() {
  if (shown_) WindowInput::of(graphics_.context->window()).discard();
}

void OpeningScreen::show(double share, const char* what) {
  if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() < kPatience) return;
  GLFWwindow* window = graphics_.context->window();
  shown_ = true;
  glfwPollEvents();  // otherwise the desktop considers the program unresponsive
  int width = 0, height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  if (width < 1 || height < 1) return;
  Framebuffer framebuffer(width, height, 1);
  framebuffer.bind();
  gl::ClearColor(0.09f, 0.10f, 0.12f, 1);
  gl::Clear(GL_COLOR_BUFFER_BIT);
  framebuffer.resolve();
  bool cancelled = false;
  do cancelled = draw(width, height, share, what);
  while (!cancelled && WindowInput::of(window).waiting());
  overlay_.draw(framebuffer);
  framebuffer.present(width, height);
  glfwSwapBuffers(window);
  if (cancelled || glfwWindowShouldClose(window)) throw Cancelled{name_};
}

bool OpeningScreen::draw(int width, int height, double share, const char* what) {
  overlay_.begin(width, height);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  // A fixed height: ImGui hides a window in its first frame if the height must be measured.
  ImGui::SetNextWindowSize({std::min(ui::px(420), 0.8f * size.x), ui::px(126)});
  ImGui::Begin("opening", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::Text("Opening %s", name_.c_str());
  ImGui::ProgressBar(static_cast<float>(share), {-1, 0});
  ImGui::TextColored(ui::kDim, "%s", what);
  ImGui::Button("Cancel", {-1, 0});
  // Frames are rare during opening, so the press counts, not the release.
  const bool cancelled =
      (ImGui::IsItemHovered() && ImGui::IsMouseClicked(0)) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  ImGui::End();
  overlay_.end();
  return cancelled;
}

}  // namespace fascia
