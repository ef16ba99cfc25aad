#include "app/ui/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "app/ui/audit.h"
#include "app/ui/style.h"
#include "app/ui/units.h"

namespace fascia::ui {
namespace {

constexpr float kClickReach = 4;                            // a press that moves farther is a drag [points]
constexpr float kLabelShare = 0.41f, kSliderShare = 0.33f;  // of a row's width; the value has the remainder

// The number being typed; the keyboard focus permits one at a time.
struct Typing {
  ImGuiID id = 0;
  std::string text, shown;
  bool fresh = false, wrong = false;
} typing;

// The slider that was pressed last, and its original value.
struct PressedSlider {
  ImGuiID id = 0;
  double value = 0;
} last_pressed;

// Replaces ^3 and the like in units by superscripts, and +- by its sign.
std::string pretty(std::string text) {
  constexpr std::pair<const char*, const char*> kSigns[] = {{"^3", "\xc2\xb3"}, {"^2", "\xc2\xb2"}, {"+-", "\xc2\xb1"}};
  for (const auto& [plain, sign] : kSigns)
    for (std::size_t at = text.find(plain); at != std::string::npos; at = text.find(plain, at))
      text.replace(at, 2, sign);
  return text;
}

// Draws text below the last item, also while the mouse is elsewhere.
void say_below(const std::string& text) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImGui::SetNextWindowPos({low.x, high.y + px(2)});
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(text.c_str());
  ImGui::EndTooltip();
}

// The text field in place of the slider. True if a new value was entered.
bool typed_number(const NumberField& field, double& value) {
  if (typing.fresh) ImGui::SetKeyboardFocusHere();
  if (typing.wrong) ImGui::PushStyleColor(ImGuiCol_Text, kDanger);
  const bool entered = ImGui::InputText("##typed", &typing.text,
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  if (typing.wrong) {
    ImGui::PopStyleColor();
    say_below("Expected a number from " + engineering(field.min, field.unit) + " to " +
              engineering(field.max, field.unit));
  }
  if (typing.fresh) {
    typing.fresh = false;
    return false;
  }
  if (!entered && !ImGui::IsItemDeactivated()) return false;
  const bool zero = !field.zero.empty() && typing.text == field.zero;
  const std::optional<double> parsed = zero ? 0.0 : parse_engineering(typing.text, field.unit);
  const bool good = parsed && *parsed >= field.min && *parsed <= field.max;
  const bool same = typing.text == typing.shown;  // it is rounded: leaving it keeps the value
  if (entered && !good && !same) {
    typing.wrong = typing.fresh = true;
    return false;
  }
  const bool changed = good && !same;
  if (changed) value = *parsed;
  typing = {};
  return changed;
}

std::set<std::string> without_help;

bool wants_to_type() {
  return (ImGui::IsItemHovered() &&
          (ImGui::IsMouseDoubleClicked(0) || (ImGui::IsMouseClicked(0) && ImGui::GetIO().KeyCtrl))) ||
         (ImGui::IsItemFocused() && ImGui::GetIO().KeyCtrl && ImGui::IsKeyPressedMap(ImGuiKey_Enter));
}

// The value at the end of the row, right-aligned. A click on it starts typing; a drag is given as its latest pixels to
// the right.
struct ValueButton {
  bool pressed;
  float dragged;
};
ValueButton value_button(const std::string& text) {
  const ImVec2 low = ImGui::GetCursorScreenPos(), size{ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight()};
  const bool released = ImGui::InvisibleButton("##value", size);
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemFocused();
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  ImGui::GetWindowDrawList()->AddText({low.x + size.x - width, low.y + ImGui::GetStyle().FramePadding.y},
                                      ImGui::GetColorU32(lit ? kAccent : kText), text.c_str());
  const ImGuiIO& io = ImGui::GetIO();
  // The largest distance since the press decides, so that a drag back to its start is no click.
  const bool moved = io.MouseDragMaxDistanceSqr[0] > kClickReach * kClickReach * px(1) * px(1);
  const bool drags = ImGui::IsItemActive() && moved && ImGui::IsMouseDown(0);
  if (ImGui::IsItemHovered() || drags)
    ImGui::SetMouseCursor(drags ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_TextInput);
  const bool by_mouse = ImGui::IsMouseReleased(0);
  return {released && !(by_mouse && moved), drags ? io.MouseDelta.x / px(1) : 0};
}

// The value after a drag of the number: half a percent per point where the slider is logarithmic, else a thousandth of
// its range.
double finely_dragged(const NumberField& field, double value, float points) {
  constexpr double kPerPoint = 0.005;
  const double step = (field.slider_max - field.slider_min) / 1000;
  const double moved = field.logarithmic && value != 0 ? value * std::exp(kPerPoint * points) : value + step * points;
  return std::clamp(moved, std::max(field.min, field.zero.empty() ? field.min : 0.0), field.max);
}

ImVec2 pill_pad() { return {px(10), px(5)}; }

std::vector<Box>& boxes_of_frame() {
  static std::vector<Box> boxes;
  static int frame = -1;
  if (frame != ImGui::GetFrameCount()) boxes.clear();
  frame = ImGui::GetFrameCount();
  return boxes;
}

// Help is also that of command lines, where it begins with a small letter. The name of a key keeps its letters.
std::string capitalized(std::string text) {
  const auto end = std::find_if(text.begin(), text.end(), [](unsigned char c) { return !std::islower(c); });
  if (end != text.begin() && (end == text.end() || *end == ' ' || *end == ','))
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace

bool section(const char* title, bool open_at_first) {
  ImGui::Dummy({0, px(2)});
  ImGui::PushFont(bold_font());
  const bool open = ImGui::CollapsingHeader(title, open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  ImGui::PopFont();
  return open;
}

void tooltip(const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsItemActive())
    return;  // it would cover the changing value
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(px(300));
  ImGui::TextUnformatted(pretty(capitalized(text)).c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void fact(const char* name, const std::string& value, const std::string& help, const ImVec4* color) {
  expect_help(name, help);
  const std::string text = pretty(value);
  ImGui::BeginGroup();
  ImGui::PushStyleColor(ImGuiCol_Text, kDim);
  ImGui::TextUnformatted(name);
  ImGui::PopStyleColor();
  ImGui::SameLine();
  const float free = ImGui::GetContentRegionAvail().x, width = ImGui::CalcTextSize(text.c_str()).x;
  if (color) ImGui::PushStyleColor(ImGuiCol_Text, *color);
  if (width < free) {
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + free - width);
    ImGui::TextUnformatted(text.c_str());
  } else {
    ImGui::TextWrapped("%s", text.c_str());
  }
  if (color) ImGui::PopStyleColor();
  ImGui::EndGroup();
  tooltip(help);
}

void label(const char* text, const std::string& help) {
  expect_help(text, help);
  const float start = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  tooltip(help);
  ImGui::SameLine(start + kLabelShare * width);
  ImGui::SetNextItemWidth(-FLT_MIN);
}

ImGuiComboFlags combo_flags(const std::string& chosen) {
  const float room = ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
  return ImGui::CalcTextSize(chosen.c_str()).x > room ? ImGuiComboFlags_NoArrowButton : ImGuiComboFlags_None;
}

bool number(const NumberField& field, double& value) {
  ImGui::PushID(field.label.c_str());
  const float row = ImGui::GetContentRegionAvail().x;
  label(field.label.c_str(), field.help);
  const ImGuiID id = ImGui::GetID("##slider");
  bool changed = false;
  if (typing.id == id) {
    changed = typed_number(field, value);
  } else {
    // Depends on the unit and not on the value: a slider that changed its width during a drag would move under the
    // mouse.
    const float gap = px(6), widest_value = ImGui::CalcTextSize(pretty("0000 " + field.unit).c_str()).x;
    ImGui::SetNextItemWidth(std::min(kSliderShare * row, (1 - kLabelShare) * row - widest_value - gap));
    const ImGuiSliderFlags flags = ImGuiSliderFlags_NoInput | (field.logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    const double before = value;
    changed =
        ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &field.slider_min, &field.slider_max, "", flags);
    tooltip(field.help);
    const bool asked_at_slider = wants_to_type();
    if (asked_at_slider) {  // the clicks that requested it have moved the knob
      const double restored = ImGui::IsMouseDoubleClicked(0) && last_pressed.id == id ? last_pressed.value : before;
      changed = restored != before;
      value = restored;
    } else if (ImGui::IsItemActivated()) {
      last_pressed = {id, before};
    }
    ImGui::SameLine(0, 0);
    const bool zero = value == 0 && !field.zero.empty();
    const ValueButton button = value_button(zero ? field.zero : pretty(engineering(value, field.unit)));
    tooltip("Click to type, drag for fine steps");
    if (button.dragged != 0 && !field.integer) {
      const double moved = finely_dragged(field, value, button.dragged);
      changed |= moved != value;
      value = moved;
    }
    if (button.pressed || asked_at_slider) {
      const std::string text = zero ? field.zero : engineering(value, field.unit, 4);
      typing = {id, text, text, true, false};
      ImGui::ClearActiveID();
    }
  }
  if (changed && field.integer) value = std::round(value);
  ImGui::PopID();
  return changed;
}

Box pill_box(const std::string& text, float x, float y, float widest) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, widest > 0 ? widest : -1);
  const float left = std::floor(x - size.x / 2 - pill_pad().x), top = std::floor(y);
  return {left, top, left + size.x + 2 * pill_pad().x, top + size.y + 2 * pill_pad().y};
}

Box pill(ImDrawList& list, const std::string& text, float x, float y, const ImVec4& color, float widest) {
  const Box box = pill_box(text, x, y, widest);
  list.AddRectFilled({box.left, box.top}, {box.right, box.bottom},
                     ImGui::GetColorU32(ImVec4(kPanel.x, kPanel.y, kPanel.z, 0.78f)), px(7));
  list.AddText(nullptr, 0, {box.left + pill_pad().x, box.top + pill_pad().y}, ImGui::GetColorU32(color), text.c_str(),
               nullptr, widest > 0 ? widest : 0);
  return box;
}

void pill(const std::string& text, float x, float y, const ImVec4& color) {
  keep_clear(pill(*ImGui::GetBackgroundDrawList(), text, x, y, color));
}

void keep_clear(const Box& box) { boxes_of_frame().push_back(box); }
const std::vector<Box>& kept_clear() { return boxes_of_frame(); }

void plot(const char* id, const RecentValues& history, float height) {
  const auto value_at = [](void* data, int i) { return static_cast<const RecentValues*>(data)->at(i); };
  float largest = 1;
  for (int i = 0; i < history.count(); ++i) largest = std::max(largest, history.at(i));
  ImGui::PlotLines(id, value_at, const_cast<RecentValues*>(&history), history.count(), 0, nullptr, 0, 1.15f * largest,
                   {ImGui::GetContentRegionAvail().x, px(height)});
}

bool button(const char* text, float width, bool lit) {
  if (lit) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.55f, 0.27f, 0.22f, 1));
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.91f, 0.92f, 0.93f, 1));  // also in light themes
  }
  const bool pressed = ImGui::Button(text, {width, 0});
  if (lit) ImGui::PopStyleColor(2);
  return pressed;
}

bool button(const char* text, const std::string& help, float width, bool lit) {
  expect_help(text, help);
  const bool pressed = button(text, width, lit);
  tooltip(help);
  return pressed;
}

bool small_button(const char* text, const std::string& help, float width) {
  expect_help(text, help);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(4), 0});
  const bool pressed = ImGui::Button(text, {width, ImGui::GetFontSize()});
  ImGui::PopStyleVar();
  tooltip(help);
  return pressed;
}

ButtonRow::ButtonRow(int count)
    : width_((ImGui::GetContentRegionAvail().x - static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x) /
             static_cast<float>(count)) {}

bool ButtonRow::add(const char* text, const std::string& help, bool lit) {
  if (!first_) ImGui::SameLine();
  first_ = false;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(2), ImGui::GetStyle().FramePadding.y});  // for narrow buttons
  const bool pressed = button(text, help, width_, lit);
  ImGui::PopStyleVar();
  return pressed;
}

void keep_inside() {
  const ImVec2 screen = ImGui::GetIO().DisplaySize, at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const ImVec2 inside{std::clamp(at.x, 0.0f, std::max(0.0f, screen.x - size.x)),
                      std::clamp(at.y, 0.0f, std::max(0.0f, screen.y - size.y))};
  if (inside.x != at.x || inside.y != at.y) ImGui::SetWindowPos(inside);
}

bool checkbox(const char* text, bool& value, const std::string& help) {
  expect_help(text, help);
  const bool changed = ImGui::Checkbox(text, &value);
  tooltip(help);
  return changed;
}

const std::set<std::string>& unexplained() { return without_help; }

void expect_help(const char* label, const std::string& help) {
  if (help.empty()) without_help.insert(label);
}

}  // namespace fascia::ui
