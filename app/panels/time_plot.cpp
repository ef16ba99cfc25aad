#include "app/panels/time_plot.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "app/ui/log_plot.h"
#include "app/ui/style.h"
#include "app/ui/ticks.h"
#include "app/ui/units.h"

namespace fascia::ui {
namespace {

constexpr float kAxis = 62;           // room for the labels at the left [points]
constexpr double kLeastShare = 1e-4;  // of the largest value: the smallest height of an axis; less would show rounding
constexpr double kShortest = 0.05, kLongest = 1200;  // seconds shown

struct Area {
  ImVec2 low, high;  // in pixels
  double begin, end, bottom, top;
  bool logarithmic;

  float x(double time) const { return low.x + (high.x - low.x) * static_cast<float>((time - begin) / (end - begin)); }
  float y(double value) const {
    const double share =
        logarithmic ? std::log(value / bottom) / std::log(top / bottom) : (value - bottom) / (top - bottom);
    return high.y - (high.y - low.y) * static_cast<float>(std::clamp(share, -1.0, 2.0));
  }
  bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }
};

void fit(Area& area, const TimeChart& chart, std::span<const Sample> samples, std::span<const Sample> measured) {
  double low = 1e300, high = -1e300;
  for (const TimeCurve& curve : chart.curves)
    for (const std::span<const Sample> part : {samples, measured})
      for (const Sample& sample : part)
        if (const double value = curve.value(sample); area.shows(value)) {
          low = std::min(low, value);
          high = std::max(high, value);
        }
  if (low > high) low = area.logarithmic ? 1e-3 : 0, high = 1;
  if (area.logarithmic) {
    area.bottom = std::pow(10.0, std::floor(std::log10(low)));
    area.top = std::max(10 * area.bottom, std::pow(10.0, std::ceil(std::log10(high))));
    return;
  }
  const double largest = std::max(std::abs(low), std::abs(high));
  const double least = largest > 0 ? kLeastShare * largest : 1;
  const double missing = std::max(0.0, least - (high - low)), margin = 0.06 * std::max(least, high - low);
  area.bottom = low - 0.5 * missing - margin;
  area.top = high + 0.5 * missing + margin;
}

void draw_axes(ImDrawList& draw, const Area& area, const char* unit, bool times) {
  const ImU32 grid = ImGui::GetColorU32(ImGuiCol_HeaderHovered), text = ImGui::GetColorU32(kDim);
  const float line = ImGui::GetFontSize();
  const int most = std::max(2, static_cast<int>((area.high.y - area.low.y) / (1.6f * line)));
  const Ticks values =
      area.logarithmic ? decade_ticks(area.bottom, area.top, most) : linear_ticks(area.bottom, area.top, most);
  for (const double value : values.values) {
    const float y = area.y(value);
    const std::string label =
        engineering(std::abs(value) < 1e-12 * (area.top - area.bottom) ? 0 : value, unit, values.digits);
    draw.AddLine({area.low.x, y}, {area.high.x, y}, grid);
    draw.AddText({area.low.x - ImGui::CalcTextSize(label.c_str()).x - px(4), y - 0.5f * line}, text, label.c_str());
  }
  const Ticks seconds =
      linear_ticks(area.begin, area.end, std::max(2, static_cast<int>((area.high.x - area.low.x) / px(64))));
  for (const double time : seconds.values) {
    const float x = area.x(time);
    draw.AddLine({x, area.low.y}, {x, area.high.y}, grid);
    if (!times) continue;
    const std::string label = engineering(std::abs(time) < 1e-9 ? 0 : time, "", seconds.digits) + " s";
    draw.AddText({x - 0.5f * ImGui::CalcTextSize(label.c_str()).x, area.high.y + px(2)}, text, label.c_str());
  }
}

// In each column of pixels, only the lowest and the highest sample.
void draw_curve(ImDrawList& draw, const Area& area, const TimeCurve& curve, std::span<const Sample> samples,
                ImU32 color) {
  std::vector<ImVec2> points;
  const auto flush = [&] {
    if (points.size() == 1) draw.AddCircleFilled(points[0], px(1.5f), color);
    if (points.size() > 1) draw.AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, px(1.5f));
    points.clear();
  };
  bool merged = false;  // the last two points share a column
  for (const Sample& sample : samples) {
    const double value = curve.value(sample);
    if (!area.shows(value)) {
      flush();
      merged = false;
      continue;
    }
    const ImVec2 at{area.x(sample.time), area.y(value)};
    const bool same = !points.empty() && std::floor(points.back().x) == std::floor(at.x);
    if (same && merged) {
      ImVec2 &first = points[points.size() - 2], &second = points.back();
      if (first.y > second.y) std::swap(first.y, second.y);
      first.y = std::min(first.y, at.y);
      second.y = std::max(second.y, at.y);
    } else {
      points.push_back(at);
      merged = same;
    }
  }
  flush();
}

// Measured values, with dashes from one to the next.
void draw_measured(ImDrawList& draw, const Area& area, const TimeCurve& curve, std::span<const Sample> measured,
                   ImU32 color) {
  std::optional<ImVec2> last;
  for (const Sample& sample : measured) {
    const double value = curve.value(sample);
    if (!area.shows(value)) continue;
    const ImVec2 at{area.x(sample.time), area.y(value)};
    if (last && at.x > area.low.x && last->x < area.high.x) {
      const float length = std::hypot(at.x - last->x, at.y - last->y), width = at.x - last->x;
      const auto place = [&](float s) { return ImVec2{last->x + s * width, last->y + s * (at.y - last->y)}; };
      // Only the part inside: a neighbor far outside would be reached by millions of dashes.
      const float begin = width > 0 ? std::max(0.0f, (area.low.x - last->x) / width) : 0,
                  end = width > 0 ? std::min(1.0f, (area.high.x - last->x) / width) : 1;
      for (float s = begin; s < end && length > 0; s += px(9) / length)
        draw.AddLine(place(s), place(std::min(end, s + px(5) / length)), color, px(1.5f));
    }
    draw.AddCircle(at, px(2.5f), color);
    last = at;
  }
}

bool has_measured(const TimeChart& chart, std::span<const Sample> measured) {
  return std::any_of(chart.curves.begin(), chart.curves.end(), [&](const TimeCurve& curve) {
    return std::any_of(measured.begin(), measured.end(),
                       [&](const Sample& sample) { return std::isfinite(curve.value(sample)); });
  });
}

void draw_legend(const TimeChart& chart, const Sample* at, bool measured) {
  ImGui::PushFont(bold_font());
  ImGui::TextUnformatted(chart.title);
  ImGui::PopFont();
  const auto add = [](const std::string& text, const ImVec4& color) {
    ImGui::SameLine(0, px(10));
    if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize(text.c_str()).x) ImGui::NewLine();
    ImGui::TextColored(color, "%s", text.c_str());
  };
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const double value = at ? chart.curves[i].value(*at) : Sample::kUnknown;
    add(chart.curves[i].name + (chart.curves[i].name.empty() ? "" : " ") +
            engineering(value, chart.unit, chart.unit[0] ? 4 : 6),
        ImGui::ColorConvertU32ToFloat4(curve_color(i)));
  }
  if (measured) add("dashed: measured", kDim);
}

// Length of the shown time [s]: while the plot follows the latest sample, at most the sampled time and at least a
// second.
double span_of(const Plots& plots) {
  const std::span<const Sample> all = plots.history.all();
  if (plots.end || all.empty()) return plots.span;
  return std::min(plots.span, std::max(1.0, all.back().time - all.front().time));
}

void follow_mouse(Plots& plots, const Area& area) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, px(3))) {
    plots.end = plots.right_edge() - io.MouseDelta.x / (area.high.x - area.low.x) * (area.end - area.begin);
  }
  if (!ImGui::IsItemHovered()) return;
  const double at = area.begin + (io.MousePos.x - area.low.x) / (area.high.x - area.low.x) * (area.end - area.begin);
  plots.cursor_next = std::clamp(at, area.begin, area.end);
  if (ImGui::IsMouseDoubleClicked(0)) plots.end.reset();
  if (io.MouseWheel == 0) return;
  const double span = std::clamp((area.end - area.begin) * std::pow(0.8, io.MouseWheel), kShortest, kLongest);
  // The time under the mouse keeps its place; while the plot follows the latest sample, the right edge does.
  if (plots.end) plots.end = *plots.cursor_next + (*plots.end - *plots.cursor_next) * span / (area.end - area.begin);
  plots.span = span;
}

}  // namespace

void time_plot(const TimeChart& chart, Plots& plots, float height, bool times) {
  const std::span<const Sample> all = plots.history.all();
  const double end = plots.right_edge(), begin = end - span_of(plots);
  const std::span<const Sample> samples = plots.history.between(begin, end);
  const std::span<const Sample> measured = plots.measured_between(begin, end);
  draw_legend(chart,
              plots.cursor  ? plots.history.nearest(*plots.cursor)
              : all.empty() ? nullptr
                            : &all.back(),
              has_measured(chart, measured));

  const ImVec2 corner = ImGui::GetCursorScreenPos(), size{ImGui::GetContentRegionAvail().x, px(height)};
  ImGui::InvisibleButton(chart.title, size);
  ImGui::SetItemUsingMouseWheel();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float bottom = times ? ImGui::GetFontSize() + px(4) : px(2);
  Area area{{corner.x + px(kAxis), corner.y + px(3)},
            {corner.x + size.x - px(6), corner.y + size.y - bottom},
            begin,
            end,
            0,
            1,
            chart.logarithmic};
  fit(area, chart, samples, measured);
  draw_axes(draw, area, chart.unit, times);
  draw.PushClipRect(area.low, area.high, true);
  for (std::size_t i = 0; i < chart.curves.size(); ++i)
    draw_curve(draw, area, chart.curves[i], samples, curve_color(i));
  for (std::size_t i = 0; i < chart.curves.size(); ++i)
    draw_measured(draw, area, chart.curves[i], measured, curve_color(i));
  if (const Sample* at = plots.cursor ? plots.history.nearest(*plots.cursor) : nullptr) {
    draw.AddLine({area.x(at->time), area.low.y}, {area.x(at->time), area.high.y}, ImGui::GetColorU32(kDim));
    for (std::size_t i = 0; i < chart.curves.size(); ++i)
      if (const double value = chart.curves[i].value(*at); area.shows(value))
        draw.AddCircleFilled({area.x(at->time), area.y(value)}, px(3), curve_color(i));
  }
  draw.PopClipRect();
  follow_mouse(plots, area);
}

}  // namespace fascia::ui
