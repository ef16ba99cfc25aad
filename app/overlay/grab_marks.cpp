#include "app/overlay/grab_marks.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/ui/style.h"
#include "app/ui/units.h"
#include "app/ui/widgets.h"

namespace fascia {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

std::optional<ImVec2> place_of(const MarkArea& area, const Session& session, const Vector3d& place) {
  const auto at = pixel_of(session, place, area.width, area.height);
  if (!at) return std::nullopt;
  return ImVec2{area.x + static_cast<float>(at->x()), static_cast<float>(at->y())};
}

// Keeps labels off the arrow of a grab.
void keep_arrow_clear(const ImVec2& from, const ImVec2& to, LabelPlaces& places) {
  const float step = ui::px(6), length = std::hypot(to.x - from.x, to.y - from.y);
  const int parts = std::clamp(static_cast<int>(length / step), 1, 200);
  for (int k = 0; k < parts; ++k) {
    const float a = static_cast<float>(k) / static_cast<float>(parts),
                b = static_cast<float>(k + 1) / static_cast<float>(parts);
    const ImVec2 p{from.x + a * (to.x - from.x), from.y + a * (to.y - from.y)},
        q{from.x + b * (to.x - from.x), from.y + b * (to.y - from.y)};
    places.keep_clear({std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)});
  }
}

}  // namespace

std::vector<GrabMark> grab_marks(const Simulation& simulation, const std::vector<GrabForce>& forces,
                                 const GrabSet* grabs) {
  const std::vector<GrabSpring>& springs = simulation.springs();
  std::vector<GrabMark> marks;
  for (std::size_t begin = 0, end = 0; begin < springs.size(); begin = end) {
    const std::uint32_t id = springs[begin].grab;
    double stiffness = 0;
    Vector3d to(0, 0, 0), force(0, 0, 0);
    for (end = begin; end < springs.size() && springs[end].grab == id; ++end) {
      stiffness += springs[end].stiffness;
      to += springs[end].stiffness * (simulation.model.rest_positions[springs[end].vertex] + springs[end].target);
    }
    if (stiffness == 0) continue;
    to /= stiffness;
    bool observed = false;
    for (const GrabForce& f : forces)
      if (f.grab == id && f.force.allFinite()) force = f.force, observed = true;
    GrabMark mark{{(to - force / stiffness).cast<float>(), to.cast<float>()}, force};
    if (grabs)
      for (std::size_t i = 0; i < grabs->all().size(); ++i)
        if (grabs->all()[i].id == id) {
          const Grab& grab = grabs->all()[i].grab;
          mark.arrow = {grab.anchor().cast<float>(), grab.pointer().cast<float>()};
          if (observed)
            mark.arrow.from +=
                ((grab.force() - force) / grab.stiffness()).cast<float>();  // for this simulation's tissue
          mark.stays = !grabs->follows(i);
        }
    marks.push_back(mark);
  }
  return marks;
}

std::vector<GrabArrow> arrows(const std::vector<GrabMark>& marks) {
  std::vector<GrabArrow> arrows;
  for (const GrabMark& mark : marks) arrows.push_back(mark.arrow);
  return arrows;
}

std::optional<Vector2d> pixel_of(const Session& session, const Vector3d& place, double width, double height) {
  const Eigen::Matrix4d transform =
      (session.camera.projection(width / height, session.look.radius) * session.camera.view()).cast<double>();
  const Eigen::Vector4d clip = transform * place.homogeneous();
  if (!(clip.w() > 0)) return std::nullopt;
  return Vector2d((0.5 + 0.5 * clip.x() / clip.w()) * width, (0.5 - 0.5 * clip.y() / clip.w()) * height);
}

MarkArea MarkArea::whole() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  return {*ImGui::GetBackgroundDrawList(), 0, size.x, size.y};
}

void draw_grab_marks(const MarkArea& area, const Session& session, const std::vector<GrabMark>& marks,
                     LabelPlaces& places) {
  const MarkSettings& shown_kinds = session.display().marks;
  ImDrawList& list = area.list;
  list.PushClipRect({area.x, 0}, {area.x + area.width, area.height}, true);
  std::vector<std::optional<ImVec2>> grabs;
  for (const GrabMark& mark : marks) {
    const auto place = place_of(area, session, mark.arrow.to.cast<double>());
    const bool shown =
        place && place->x >= area.x && place->x < area.x + area.width && place->y >= 0 && place->y < area.height;
    grabs.push_back(shown ? place : std::nullopt);
    if (!shown) continue;
    const float reach = ui::px(8);
    places.keep_clear({place->x - reach, place->y - reach, place->x + reach, place->y + reach});
    if (const auto from = place_of(area, session, mark.arrow.from.cast<double>()); from && shown_kinds.grabs)
      keep_arrow_clear(*from, *place, places);
    if (mark.stays && shown_kinds.grabs) {
      const float radius = static_cast<float>(kMarkRadius) * area.height / 720;
      list.AddCircleFilled(*place, radius,
                           ImGui::GetColorU32(ImVec4(ui::kAccent.x, ui::kAccent.y, ui::kAccent.z, 0.35f)));
      list.AddCircle(*place, radius, ImGui::GetColorU32({1, 1, 1, 0.95f}), 0, ui::px(2));
    }
  }
  for (std::size_t i = 0; i < marks.size() && shown_kinds.forces; ++i) {
    if (!grabs[i]) continue;
    const std::string force = engineering(marks[i].force.norm(), "N");
    const Box label = places.place(ui::pill_box(force, grabs[i]->x + ui::px(44), grabs[i]->y - ui::px(34)));
    ui::pill(list, force, 0.5f * (label.left + label.right), label.top, ui::kText);
  }
  list.PopClipRect();
}

void draw_patch_ring(const MarkArea& area, const Session& session, const Vector3d& place, const Vector3d& normal,
                     double radius) {
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  constexpr int kCorners = 64;
  std::vector<ImVec2> ring;
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2 * std::numbers::pi * k / kCorners;
    const auto at = place_of(area, session, place + radius * (std::cos(angle) * u + std::sin(angle) * v));
    if (!at) return;
    ring.push_back(*at);
  }
  ImDrawList& list = area.list;
  list.PushClipRect({area.x, 0}, {area.x + area.width, area.height}, true);
  list.AddPolyline(ring.data(), kCorners, ImGui::GetColorU32({0, 0, 0, 0.35f}), ImDrawFlags_Closed, ui::px(3.5f));
  list.AddPolyline(ring.data(), kCorners, ImGui::GetColorU32({1, 1, 1, 0.9f}), ImDrawFlags_Closed, ui::px(1.6f));
  list.PopClipRect();
}

void draw_brush_marks(const MarkArea& area, const Session& session, const std::vector<Vector3d>& places,
                      const ImVec4& color) {
  constexpr std::size_t kMost = 3000;
  const bool bright = color.x + color.y + color.z > 1.5f;
  const std::size_t step = places.size() / kMost + 1;
  for (std::size_t i = 0; i < places.size(); i += step) {
    const auto middle = place_of(area, session, places[i]);
    if (!middle) continue;
    area.list.AddCircleFilled(*middle, ui::px(3), ImGui::GetColorU32(color));
    area.list.AddCircle(*middle, ui::px(3), bright ? IM_COL32(0, 0, 0, 200) : IM_COL32(255, 255, 255, 200));
  }
}

void draw_lasso(const MarkArea& area, const std::vector<Vector2d>& curve) {
  if (curve.size() < 2) return;
  std::vector<ImVec2> points;
  for (const Vector2d& place : curve)
    points.push_back({area.x + static_cast<float>(place.x()), static_cast<float>(place.y())});
  const auto count = static_cast<int>(points.size());
  area.list.AddPolyline(points.data(), count, IM_COL32(0, 0, 0, 120), ImDrawFlags_Closed, ui::px(3.5f));
  area.list.AddPolyline(points.data(), count, IM_COL32(255, 255, 255, 230), ImDrawFlags_Closed, ui::px(1.6f));
}

void draw_probe(const MarkArea& area, const Session& session, const Vector3d& place) {
  const auto middle = place_of(area, session, place);
  if (!middle) return;
  area.list.AddCircleFilled(*middle, ui::px(5), IM_COL32(0, 0, 0, 160));
  area.list.AddCircleFilled(*middle, ui::px(3.2f), ImGui::GetColorU32(ui::kWarning));
}

}  // namespace fascia
