#include "app/ui/icons.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "app/ui/audit.h"
#include "app/ui/style.h"
#include "app/ui/widgets.h"

namespace fascia::ui {
namespace {

constexpr float kSpacing = 2, kGap = 8;  // between buttons and between groups [points]
constexpr float kLargestSide = 34;       // [points]
constexpr float kPi = std::numbers::pi_v<float>;

/// Strokes in a square from (-1, -1) at the top left to (1, 1).
class Pen {
 public:
  Pen(ImDrawList& list, ImVec2 center, float half, ImU32 color)
      : list_(list), center_(center), half_(half), color_(color), width_(std::max(1.0f, 0.17f * half)) {}

  void line(std::initializer_list<ImVec2> points, bool closed = false) {
    for (const ImVec2& p : points) list_.PathLineTo(at(p));
    list_.PathStroke(color_, closed ? ImDrawFlags_Closed : 0, width_);
  }
  void fill(std::initializer_list<ImVec2> points) {  // convex, clockwise
    for (const ImVec2& p : points) list_.PathLineTo(at(p));
    list_.PathFillConvex(color_);
  }
  void box(float left, float top, float right, float bottom) {
    list_.AddRect(at({left, top}), at({right, bottom}), color_, 0.12f * half_, 0, width_);
  }
  void filled_box(float left, float top, float right, float bottom) {
    list_.AddRectFilled(at({left, top}), at({right, bottom}), color_, 0.08f * half_);
  }
  void circle(ImVec2 middle, float radius) { list_.AddCircle(at(middle), radius * half_, color_, 0, width_); }
  void dot(ImVec2 middle, float radius) { list_.AddCircleFilled(at(middle), radius * half_, color_); }
  /// Angles clockwise from the right [rad].
  void arc(ImVec2 middle, float radius, float from, float to) {
    list_.PathArcTo(at(middle), radius * half_, from, to, 20);
    list_.PathStroke(color_, 0, width_);
  }
  void text(const char* letters) {
    const float size = 1.9f * half_;
    const ImVec2 extent = bold_font()->CalcTextSizeA(size, 1e6f, 0, letters);
    list_.AddText(bold_font(), size, {center_.x - 0.5f * extent.x, center_.y - 0.5f * extent.y}, color_, letters);
  }

 private:
  ImVec2 at(const ImVec2& p) const { return {center_.x + p.x * half_, center_.y + p.y * half_}; }

  ImDrawList& list_;
  ImVec2 center_;
  float half_;
  ImU32 color_;
  float width_;
};

// An arrow that turns back; mirrored for redo.
void turn_back(Pen& pen, float side) {
  pen.line({{side * -0.35f, -0.85f}, {side * -0.85f, -0.35f}, {side * -0.35f, 0.15f}});
  pen.line({{side * -0.8f, -0.35f}, {side * 0.25f, -0.35f}});
  pen.arc({side * 0.25f, 0.2f}, 0.55f, -0.5f * kPi, 0.5f * kPi * (side > 0 ? 1 : -3));
  pen.line({{side * 0.25f, 0.75f}, {side * -0.35f, 0.75f}});
}

void draw(Pen& pen, Icon icon) {
  switch (icon) {
    case Icon::open:  // a folder
      pen.line({{-0.9f, 0.7f}, {-0.9f, -0.7f}, {-0.3f, -0.7f}, {-0.05f, -0.4f}, {0.75f, -0.4f}, {0.75f, -0.05f}});
      pen.line({{-0.9f, 0.7f}, {-0.55f, -0.05f}, {1, -0.05f}, {0.7f, 0.7f}}, true);
      break;
    case Icon::recent:  // a clock
      pen.circle({0, 0}, 0.85f);
      pen.line({{0, -0.5f}, {0, 0.05f}, {0.4f, 0.3f}});
      break;
    case Icon::examples:  // pictures in a grid
      pen.box(-0.9f, -0.8f, -0.12f, -0.1f);
      pen.box(0.12f, -0.8f, 0.9f, -0.1f);
      pen.box(-0.9f, 0.15f, -0.12f, 0.85f);
      pen.box(0.12f, 0.15f, 0.9f, 0.85f);
      break;
    case Icon::save:  // into a tray
      pen.line({{0, -0.9f}, {0, 0.3f}});
      pen.line({{-0.4f, -0.1f}, {0, 0.3f}, {0.4f, -0.1f}});
      pen.line({{-0.85f, 0.3f}, {-0.85f, 0.85f}, {0.85f, 0.85f}, {0.85f, 0.3f}});
      break;
    case Icon::export_state:  // out of a box
      pen.line({{-0.1f, -0.75f}, {-0.85f, -0.75f}, {-0.85f, 0.85f}, {0.75f, 0.85f}, {0.75f, 0.15f}});
      pen.line({{-0.2f, 0.2f}, {0.85f, -0.85f}});
      pen.line({{0.3f, -0.85f}, {0.85f, -0.85f}, {0.85f, -0.3f}});
      break;
    case Icon::undo:
      turn_back(pen, 1);
      break;
    case Icon::redo:
      turn_back(pen, -1);
      break;
    case Icon::compare:  // two halves
      pen.box(-0.95f, -0.7f, 0.95f, 0.7f);
      pen.filled_box(0, -0.7f, 0.95f, 0.7f);
      break;
    case Icon::help:
      pen.text("?");
      break;
    case Icon::play:
      pen.fill({{-0.6f, -0.85f}, {0.85f, 0}, {-0.6f, 0.85f}});
      break;
    case Icon::pause:
      pen.filled_box(-0.65f, -0.8f, -0.15f, 0.8f);
      pen.filled_box(0.15f, -0.8f, 0.65f, 0.8f);
      break;
    case Icon::step:
      pen.filled_box(-0.8f, -0.8f, -0.45f, 0.8f);
      pen.fill({{-0.2f, -0.8f}, {0.85f, 0}, {-0.2f, 0.8f}});
      break;
    case Icon::reset:  // a circle that goes back to its start
      pen.arc({0, 0.05f}, 0.78f, -0.75f * kPi, 0.95f * kPi);
      pen.line({{-0.6f, -0.98f}, {-0.6f, -0.45f}, {-0.05f, -0.45f}});
      break;
    case Icon::screenshot:  // a camera
      pen.line({{-0.95f, -0.45f}, {-0.5f, -0.45f}, {-0.3f, -0.75f}, {0.3f, -0.75f}, {0.5f, -0.45f}, {0.95f, -0.45f}});
      pen.line({{-0.95f, -0.45f}, {-0.95f, 0.75f}, {0.95f, 0.75f}, {0.95f, -0.45f}});
      pen.circle({0, 0.12f}, 0.38f);
      break;
    case Icon::video:  // a film camera
      pen.box(-0.95f, -0.6f, 0.4f, 0.6f);
      pen.fill({{0.5f, 0}, {0.95f, -0.5f}, {0.95f, 0.5f}});
      break;
    case Icon::stop:
      pen.filled_box(-0.65f, -0.65f, 0.65f, 0.65f);
      break;
    case Icon::recording:  // sliders
      for (const auto& [y, knob] : {std::pair{-0.6f, 0.35f}, {0.05f, -0.4f}, {0.7f, 0.1f}}) {
        pen.line({{-0.9f, y}, {0.9f, y}});
        pen.dot({knob, y}, 0.26f);
      }
      break;
    case Icon::plots:  // a curve over two axes
      pen.line({{-0.85f, -0.85f}, {-0.85f, 0.8f}, {0.95f, 0.8f}});
      pen.line({{-0.55f, 0.4f}, {-0.15f, -0.3f}, {0.25f, 0.15f}, {0.85f, -0.65f}});
      break;
    case Icon::brush:
      pen.line({{0.85f, -0.85f}, {-0.1f, 0.15f}});
      pen.fill({{-0.25f, 0.05f}, {0.08f, 0.38f}, {-0.35f, 0.8f}, {-0.85f, 0.85f}, {-0.6f, 0.3f}});
      break;
  }
}

}  // namespace

bool icon_button(Icon icon, const char* name, const std::string& help, float side, bool lit, bool usable) {
  expect_help(name, help);
  if (lit) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_TabActive));
  ImGui::PushID(name);
  const bool pressed = ImGui::Button("##icon", {side, side}) && usable;
  ImGui::PopID();
  if (lit) ImGui::PopStyleColor();
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  Pen pen(*ImGui::GetWindowDrawList(), {0.5f * (low.x + high.x), 0.5f * (low.y + high.y)}, 0.29f * side,
          ImGui::GetColorU32(usable ? kText : ImVec4(kDim.x, kDim.y, kDim.z, 0.5f)));
  draw(pen, icon);
  tooltip(std::string(name) + (help.empty() ? "" : "\n" + help));
  return pressed;
}

IconRow::IconRow(int count, int gaps) : gap_(px(kGap)) {
  const float room = ImGui::GetContentRegionAvail().x - static_cast<float>(gaps) * (gap_ - px(kSpacing)) -
                     static_cast<float>(count - 1) * px(kSpacing);
  side_ = std::min(std::floor(room / static_cast<float>(count)), px(kLargestSide));
}

bool IconRow::add(Icon icon, const char* name, const std::string& help, bool lit, bool usable) {
  if (!first_) ImGui::SameLine(0, after_gap_ ? gap_ : px(kSpacing));
  first_ = after_gap_ = false;
  return icon_button(icon, name, help, side_, lit, usable);
}

void IconRow::gap() { after_gap_ = true; }

}  // namespace fascia::ui
