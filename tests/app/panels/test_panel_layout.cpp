// The layout of panels: inside pictures of any size, beside the labels over the picture; and the gaps within their
// rows.
#include <imgui.h>
#include <imgui_internal.h>
#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "app/compare/split_view.h"
#include "app/ui/style.h"
#include "app/ui/widgets.h"
#include "tests/app/panels/desk.h"

using namespace fascia;
using namespace fascia::test;

namespace {

/// Over pictures of changing size.
struct LayoutDesk : Desk {
  void frame(int width, int height, const std::function<void()>& draw) {
    Framebuffer framebuffer(width, height, 1);
    overlay.draw_headless(session, framebuffer, false, std::nullopt, {}, draw);
  }
  void show_plots(int width, int height, const std::function<void()>& more = {}) {
    frame(width, height, [&] {
      Requests requests;
      draw_plots(session.simulation, state, requests);
      if (more) more();
    });
  }
  std::array<float, 4> place() const {
    return {state.plots.left, state.plots.top, state.plots.width, state.plots.height};
  }
  bool inside(float width, float height) const {
    const Plots& p = state.plots;
    return p.left >= 0 && p.top >= 0 && p.left + p.width <= width && p.top + p.height <= height;
  }
};

}  // namespace

TEST_CASE("the panel Plots keeps its place at the edge when the window shrinks and grows", "[panel_layout]") {
  LayoutDesk desk;
  desk.state.plots.shown = true;
  desk.show_plots(1280, 720);
  const std::array<float, 4> docked = desk.place();
  CHECK(docked == std::array<float, 4>{840, 10, 430, 700});
  desk.show_plots(640, 480);
  CHECK(desk.inside(640, 480));
  CHECK(desk.state.plots.at_bottom);
  CHECK(desk.state.plots.height > 180);
  desk.show_plots(1280, 720);
  CHECK(desk.place() == docked);

  INFO("where it was put it stays, but inside");
  desk.frame(1280, 720, [&] {
    ImGui::SetNextWindowPos({800, 400});
    ImGui::SetNextWindowSize({400, 300});
    Requests requests;
    draw_plots(desk.session.simulation, desk.state, requests);
  });
  CHECK(desk.place() == std::array<float, 4>{800, 400, 400, 300});
  desk.show_plots(640, 480);
  CHECK(desk.inside(640, 480));
  CHECK(desk.state.plots.width == 400);
}

TEST_CASE("docked plots leave room for the tissue, and the picture knows what they cover", "[panel_layout]") {
  LayoutDesk desk;
  desk.state.plots.shown = true;
  for (const auto& [width, height] : {std::pair(1280, 720), {1000, 700}, {800, 600}})
    for (const float gallery : {0.0f, 150.0f}) {
      desk.state.gallery_height = gallery;
      for (int frame = 0; frame < 2; ++frame)
        desk.show_plots(width, height, [&, width = width, height = height] {
          const Room room = room_beside_panels(desk.state);
          const Cover cover = cover_of(desk.state);
          CAPTURE(width, height, gallery, room.right, room.bottom, cover.right, cover.bottom);
          CHECK(desk.inside(static_cast<float>(width), static_cast<float>(height) - gallery));
          CHECK(room.right - room.left >= (width == 800 ? 440 : 400));
          CHECK(room.bottom >= 0.3 * height);
          const Plots& plots = desk.state.plots;  // beside or below the rest
          CHECK((plots.left >= room.right || plots.top >= room.bottom));
        });
    }
}

TEST_CASE("every panel is on a tab or above the tabs, and its tab is inside the column", "[panel_layout]") {
  LayoutDesk desk;
  for (int frame = 0; frame < 2; ++frame)
    desk.frame(800, 600, [&] {
      Requests requests;
      draw_panels({desk.session, desk.state, requests});
    });
  const ImGuiTabBar& bar = *ImGui::GetCurrentContext()->TabBars.GetByIndex(0);
  std::set<std::string> tabs;
  for (const Panel& panel : panels())
    if (panel.tab) tabs.insert(panel.tab);
  REQUIRE(bar.Tabs.Size == static_cast<int>(tabs.size()));
  for (const ImGuiTabItem& tab : bar.Tabs) {
    CAPTURE(tab.Offset, tab.Width, tab.ContentWidth);
    CHECK(tab.Width >= tab.ContentWidth);  // not cut off
    CHECK(tab.Offset + tab.Width <= panel_width() - 20);
  }
}

TEST_CASE("the list of keys is inside the picture, at any size", "[panel_layout]") {
  LayoutDesk desk;
  desk.state.show_help = true;
  for (const auto& [width, height] : {std::pair(1280, 720), {800, 600}, {480, 360}}) {
    for (int frame = 0; frame < 3; ++frame) desk.frame(width, height, [&] { draw_help(desk.state); });
    const ImGuiWindow& window = *ImGui::FindWindowByName("Keys and mouse");
    CAPTURE(width, height, window.Pos.x, window.Pos.y, window.Size.x, window.Size.y);
    CHECK(window.Pos.x >= 0);
    CHECK(window.Pos.y >= 0);
    CHECK(window.Pos.x + window.Size.x <= static_cast<float>(width));
    CHECK(window.Pos.y + window.Size.y <= static_cast<float>(height));
  }
}

TEST_CASE("labels over the picture are beside docked plots", "[panel_layout]") {
  LayoutDesk desk;
  desk.frame(1280, 720, [&] {
    const Room room = room_beside_panels(desk.state);
    CHECK(room.left == panel_space());
    CHECK(room.right == 1280);
  });
  desk.state.plots.shown = true;
  desk.state.statistics.keeps_pace = false;
  float reach = 0;
  desk.show_plots(1280, 720, [&] {
    const Room room = room_beside_panels(desk.state);
    CHECK(room.right == 840);
    const ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const int before = list.VtxBuffer.Size;
    draw_notice(desk.state, room);
    REQUIRE(list.VtxBuffer.Size > before);
    for (int i = before; i < list.VtxBuffer.Size; ++i) reach = std::max(reach, list.VtxBuffer[i].pos.x);
  });
  CHECK(reach > 400);
  CHECK(reach < 840);
  desk.state.plots.docked = false;
  desk.frame(1280, 720, [&] { CHECK(room_beside_panels(desk.state).right == 1280); });
}

TEST_CASE("labels in the picture keep clear of the time of a recording", "[panel_layout]") {
  LayoutDesk desk;
  desk.frame(1280, 720, [&] {
    draw_recording_dot(12.5, 3);
    REQUIRE(ui::kept_clear().size() == 1);
    const Box box = ui::kept_clear().front();
    CHECK(box.right == 1264);
    CHECK(box.left == 1240 - ImGui::CalcTextSize("12.5 s, repeated frames: 3").x);
    CHECK(box.bottom - box.top == ImGui::GetFontSize());
  });
}

TEST_CASE("the notice of a slow window says while kernels compile, where there is room", "[panel_layout]") {
  LayoutDesk desk;
  desk.state.statistics.keeps_pace = false;
  desk.state.statistics.speed = 0.85;
  Room room{};
  const auto edges_of = [&](bool compiling, float width) {  // of the notice in a room of that width
    desk.state.statistics.compiling = compiling;
    std::array<float, 2> edges{1e9f, 0};
    desk.frame(1280, 720, [&] {
      room = room_beside_panels(desk.state);
      room.right = room.left + width;
      const ImDrawList& list = *ImGui::GetBackgroundDrawList();
      const int before = list.VtxBuffer.Size;
      draw_notice(desk.state, room);
      for (int i = before; i < list.VtxBuffer.Size; ++i) {
        edges[0] = std::min(edges[0], list.VtxBuffer[i].pos.x);
        edges[1] = std::max(edges[1], list.VtxBuffer[i].pos.x);
      }
    });
    return edges;
  };
  const auto plain = edges_of(false, 470), longer = edges_of(true, 470);
  CHECK(longer[1] - longer[0] > plain[1] - plain[0] + 50);
  CHECK(longer[0] > room.left);
  CHECK(longer[1] < room.right);
  CHECK(edges_of(true, 300) == edges_of(false, 300));
}

TEST_CASE("a value does not touch its slider", "[panel_layout]") {
  LayoutDesk desk;
  desk.frame(1280, 720, [&] {
    ImGui::SetNextWindowSize({panel_width(), 300});
    ImGui::Begin("row");
    double density = 1060;
    ui::number({"Density", "kg/m^3", 500, 2000, 1, 1e5, false, false, "help"}, density);
    const float room = ImGui::GetItemRectMax().x - ImGui::GetItemRectMin().x;  // of the value, between slider and edge
    ImGui::End();
    CHECK(room > ImGui::CalcTextSize("1060 kg/m\xc2\xb3").x + 4);
  });
}

TEST_CASE("a sleeping side of a comparison is labeled as such", "[panel_layout]") {
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  scene.gravity.setZero();
  Graphics graphics = open_graphics(headless(), false);
  Session session(graphics, scene, false);
  CHECK(side_result(session, std::nullopt, 12.94, true) == "12.9 ms a step");
  for (int i = 0; i < 300 && !session.simulation.asleep(); ++i) session.simulation.step();
  REQUIRE(session.simulation.asleep());
  CHECK(side_result(session, std::nullopt, 0.01, true) == "at rest, asleep");
  CHECK(side_result(session, std::nullopt, 0.01, false).empty());
}
