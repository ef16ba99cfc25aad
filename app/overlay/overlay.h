// Draws over the picture: the panels, and lists of marks and labels. Owns the ImGui context; works in a window and
// headless. Everything is laid out in pixels of the picture, so that a window, a screenshot and a headless rendering
// look alike.
#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "app/overlay/grab_marks.h"
#include "app/session/graphics.h"
#include "app/session/session.h"
#include "app/ui/style.h"
#include "render/passes/imgui_renderer.h"

struct ImDrawList;

namespace fascia {

class Overlay {
 public:
  explicit Overlay(Graphics& graphics);
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// Draws one frame of panels (if requested), legend and forces of grabs over the resolved framebuffer, without a
  /// window. `more` is called to draw additional content with ImGui.
  void draw_headless(Session& session, Framebuffer& framebuffer, bool panels,
                     const std::optional<Diagnostics>& diagnostics, const std::vector<GrabMark>& grabs,
                     const std::function<void()>& more = {});
  /// Sets the scale, so that lengths in pixels and texts are measured correctly before the first picture of this
  /// height.
  void scale_to(int height);
  /// Font of the legend in the pictures from the next scale_to() or begin() on [points].
  void set_legend_font(double size) { legend_font_ = static_cast<float>(size); }

  /// The sequence of a window's frame: begin, which gives ImGui the next input (WindowInput::feed); any ImGui calls;
  /// end; then draw over the resolved framebuffer, first the part that belongs to the picture, then the rest (ImGui's
  /// foreground layer).
  void begin(int width, int height);
  void end();
  void draw(const Framebuffer& framebuffer);
  void draw_foreground(const Framebuffer& framebuffer);
  /// Draws the same frame over a picture of another size, as large as fits; without `panels` only the layer behind
  /// them.
  void draw_onto(const Framebuffer& framebuffer, bool panels);
  /// The areas that windows, pills and other texts of the frame cover [pixels of the frame].
  std::vector<Box> covered() const;
  float scale_onto(const Framebuffer& framebuffer) const;  // scale of that frame on it
  /// Draws the output of `paint`, in units of `scale` pixels, over the picture. Call after the first begin().
  void draw_list(const Framebuffer& framebuffer, float scale, const std::function<void(ImDrawList&)>& paint);

 private:
  void set_scale(float scale);
  void draw_lists(const Framebuffer& framebuffer, bool foreground);

  Graphics& graphics_;
  std::unique_ptr<ImguiRenderer> renderer_;
  float scale_ = 0, loaded_legend_font_ = 0, legend_font_ = ui::kFontSize;
};

}  // namespace fascia
