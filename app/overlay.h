// What is drawn over the picture: the panels and the heat map's color bar. Owns the ImGui context; works in a window and headless.
#pragma once
#include <memory>
#include <optional>

#include "app/graphics.h"
#include "app/session.h"
#include "render/imgui_renderer.h"

namespace fascia {

class Overlay {
 public:
  explicit Overlay(Graphics& graphics);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// One frame of panels (if wanted) and color bar over the resolved framebuffer, without a window.
  void draw_headless(Session& session, Framebuffer& framebuffer, bool panels, const std::optional<Diagnostics>& diagnostics);

 private:
  std::unique_ptr<ImguiRenderer> renderer_;
};

}  // namespace fascia
