#include <imgui/imgui.h>

#include "render/passes/imgui_renderer.h"
#include "render/target/framebuffer.h"
#include "tests/render/scene_support.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using test::color_at;

constexpr int kWidth = 320, kHeight = 200;

/// A separate ImGui context, drawn by fascia's renderer.
class Panels {
 public:
  explicit Panels(float scale = 1) : scale_(scale), imgui_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {kWidth / scale, kHeight / scale};
    io.DisplayFramebufferScale = {scale, scale};
    renderer_.emplace(programs_);
  }
  ~Panels() {
    renderer_.reset();
    ImGui::DestroyContext(imgui_);
  }
  Panels(const Panels&) = delete;
  Panels& operator=(const Panels&) = delete;

  template <class Content>
  Image draw(Content content) {
    ImGui::NewFrame();
    content();
    ImGui::Render();
    const Framebuffer target(kWidth, kHeight, 1);
    target.bind();
    gl::ClearColor(0, 0, 1, 1);
    gl::Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    renderer_->draw(*ImGui::GetDrawData());
    CHECK(gl::GetError() == GL_NO_ERROR);
    CHECK(gl::IsEnabled(GL_SCISSOR_TEST) == GL_FALSE);
    CHECK(gl::IsEnabled(GL_BLEND) == GL_FALSE);
    return target.read();
  }

 private:
  float scale_;
  gl::ProgramCache programs_{test::source_dir() / "shaders", gl::LoadPath::texel};
  ImGuiContext* imgui_;
  std::optional<ImguiRenderer> renderer_;
};

const Vector3d kBlue(0, 0, 1), kRed(1, 0, 0), kGreen(0, 1, 0);

}  // namespace

TEST_CASE("imgui: a window has the style's color in its area, with text in it") {
  const auto context = test::each_context();
  Panels panels;
  const Image image = panels.draw([] {
    ImGui::GetStyle().Colors[ImGuiCol_WindowBg] = {0.2f, 0.4f, 0.6f, 1};
    ImGui::SetNextWindowPos({40, 30});
    ImGui::SetNextWindowSize({120, 100});
    ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar);
    ImGui::TextUnformatted("tissue");
    ImGui::End();
  });
  const auto close = [](const Vector3d& a, const Vector3d& b) { return (a - b).cwiseAbs().maxCoeff() <= 1.0 / 255; };
  CHECK(close(color_at(image, 100, 110), Vector3d(0.2, 0.4, 0.6)));
  CHECK(close(color_at(image, 30, 60), kBlue));
  CHECK(close(color_at(image, 100, 20), kBlue));
  CHECK(close(color_at(image, 170, 60), kBlue));
  int bright = 0;
  for (int y = 32; y < 60; ++y)
    for (int x = 42; x < 158; ++x) bright += color_at(image, x, y).minCoeff() > 0.9;
  CAPTURE(bright);
  CHECK(bright > 20);  // six letters of seven by thirteen pixels
}

TEST_CASE("imgui: rectangles obey their clip and blend with the background") {
  const auto context = test::each_context();
  Panels panels;
  const Image image = panels.draw([] {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({50, 40}, {100, 80});
    list.AddRectFilled({0, 0}, {320, 200}, IM_COL32(255, 0, 0, 255));
    list.PopClipRect();
    list.PushClipRect({-20, 150}, {30, 400});  // extends beyond the picture
    list.AddRectFilled({0, 0}, {320, 200}, IM_COL32(0, 255, 0, 255));
    list.PopClipRect();
    list.AddRectFilled({200, 40}, {250, 80}, IM_COL32(255, 0, 0, 128));
  });
  for (const int x : {50, 99})
    for (const int y : {40, 79}) CHECK(color_at(image, x, y) == kRed);
  for (const auto& [x, y] : {std::pair(49, 60), std::pair(100, 60), std::pair(70, 39), std::pair(70, 80)}) {
    CAPTURE(x, y);
    CHECK(color_at(image, x, y) == kBlue);
  }
  CHECK(color_at(image, 5, 195) == kGreen);
  CHECK(color_at(image, 40, 195) == kBlue);
  CHECK(color_at(image, 5, 140) == kBlue);
  const Vector3d mixed = color_at(image, 220, 60);
  CAPTURE(mixed.transpose());
  CHECK((mixed - Vector3d(0.5, 0, 0.5)).cwiseAbs().maxCoeff() <= 1.5 / 255);
}

TEST_CASE("imgui: more vertices than 16-bit indices permit") {
  const auto context = test::each_context();
  Panels panels;
  const Image image = panels.draw([] {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (int i = 0; i < 20000; ++i) list.AddRectFilled({10, 10}, {12, 12}, IM_COL32(255, 0, 0, 255));
    list.AddRectFilled({100, 100}, {140, 140}, IM_COL32(0, 255, 0, 255));
    CHECK(list.VtxBuffer.Size > 65536);
  });
  CHECK(color_at(image, 11, 11) == kRed);
  CHECK(color_at(image, 120, 120) == kGreen);
  CHECK(color_at(image, 200, 120) == kBlue);
}

TEST_CASE("imgui: a scaled display") {
  const auto context = test::each_context();
  Panels panels(2);
  const Image image = panels.draw([] {
    ImGui::GetBackgroundDrawList()->AddRectFilled({10, 20}, {30, 40}, IM_COL32(255, 0, 0, 255));
  });
  CHECK(color_at(image, 40, 60) == kRed);
  CHECK(color_at(image, 18, 60) == kBlue);
  CHECK(color_at(image, 62, 60) == kBlue);
}

}  // namespace fascia
