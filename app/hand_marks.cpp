#include "app/hand_marks.h"

#include <imgui.h>

#include <cmath>
#include <numbers>

#include "app/panels.h"
#include "app/ui_style.h"
#include "app/units.h"

namespace fascia {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::vector<HandMark> hand_marks(const Simulation& simulation, const std::vector<HandForce>& forces, const Hands* hands) {
  const std::vector<GrabSpring>& springs = simulation.springs();
  std::vector<HandMark> marks;
  for (std::size_t begin = 0, end = 0; begin < springs.size(); begin = end) {
    const std::uint32_t hand = springs[begin].hand;
    double stiffness = 0;
    Vector3d to(0, 0, 0), force(0, 0, 0);
    for (end = begin; end < springs.size() && springs[end].hand == hand; ++end) {
      stiffness += springs[end].stiffness;
      to += springs[end].stiffness * (simulation.model.rest_positions[springs[end].vertex] + springs[end].target);
    }
    if (stiffness == 0) continue;
    to /= stiffness;
    for (const HandForce& f : forces)
      if (f.hand == hand && f.force.allFinite()) force = f.force;
    HandMark mark{{(to - force / stiffness).cast<float>(), to.cast<float>()}, force};
    if (hands)
      for (std::size_t i = 0; i < hands->all().size(); ++i)
        if (hands->all()[i].id == hand) {
          mark.arrow = hands->all()[i].grab.mark();
          mark.stays = !hands->follows(i);
        }
    marks.push_back(mark);
  }
  return marks;
}

std::vector<GrabMark> arrows(const std::vector<HandMark>& marks) {
  std::vector<GrabMark> arrows;
  for (const HandMark& mark : marks) arrows.push_back(mark.arrow);
  return arrows;
}

std::optional<Vector2d> pixel_of(const Session& session, const Vector3d& place, int width, int height) {
  const Eigen::Matrix4d transform =
      (session.camera.projection(static_cast<double>(width) / height, session.look.radius) * session.camera.view()).cast<double>();
  const Eigen::Vector4d clip = transform * place.homogeneous();
  if (!(clip.w() > 0)) return std::nullopt;
  return Vector2d((0.5 + 0.5 * clip.x() / clip.w()) * width, (0.5 - 0.5 * clip.y() / clip.w()) * height);
}

void draw_hand_marks(const Session& session, const std::vector<HandMark>& marks) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const int width = static_cast<int>(size.x), height = static_cast<int>(size.y);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (const HandMark& mark : marks) {
    const auto at = pixel_of(session, mark.arrow.to.cast<double>(), width, height);
    if (!at) continue;
    const ImVec2 place{static_cast<float>(at->x()), static_cast<float>(at->y())};
    if (mark.stays) {
      const float radius = static_cast<float>(kMarkRadius) * size.y / 720;
      list.AddCircleFilled(place, radius, ImGui::GetColorU32(ImVec4(ui::kAccent.x, ui::kAccent.y, ui::kAccent.z, 0.35f)));
      list.AddCircle(place, radius, ImGui::GetColorU32({1, 1, 1, 0.95f}), 0, ui::px(2));
    }
    draw_pill(engineering(mark.force.norm(), "N"), place.x + ui::px(44), place.y - ui::px(34));
  }
}

void draw_patch_ring(const Session& session, const Vector3d& place, const Vector3d& normal, double radius) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  constexpr int kCorners = 64;
  std::vector<ImVec2> ring;
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2 * std::numbers::pi * k / kCorners;
    const auto at = pixel_of(session, place + radius * (std::cos(angle) * u + std::sin(angle) * v), static_cast<int>(size.x),
                             static_cast<int>(size.y));
    if (!at) return;
    ring.push_back({static_cast<float>(at->x()), static_cast<float>(at->y())});
  }
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddPolyline(ring.data(), kCorners, ImGui::GetColorU32({0, 0, 0, 0.35f}), ImDrawFlags_Closed, ui::px(3.5f));
  list.AddPolyline(ring.data(), kCorners, ImGui::GetColorU32({1, 1, 1, 0.9f}), ImDrawFlags_Closed, ui::px(1.6f));
}

}  // namespace fascia
