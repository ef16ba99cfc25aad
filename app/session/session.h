// Where simulation and drawing meet: the one place that hands the solver's buffers to the renderer.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/session/graphics.h"
#include "render/scene_renderer.h"
#include "render/target/framebuffer.h"
#include "render/view/camera.h"
#include "sim/grab/build_model.h"
#include "sim/simulation/simulation.h"
#include "sim/simulation/true_error.h"
#include "sim/visual/visual_regions.h"
#include "sim/visual/visual_surface.h"

namespace fascia {

class Session {
 public:
  /// Throws Error; a window then keeps the session it has.
  Session(Graphics& graphics, Scene scene, Model built, bool use_reference,
          const Progress& progress = {});  // build_model(scene)
  Session(Graphics& graphics, const Scene& scene, bool use_reference)
      : Session(graphics, scene, build_model(scene), use_reference) {}

  Simulation simulation;
  TrueError true_error;
  bool follow_true_error = false;  // one measurement after the other
  Camera camera;
  Eigen::Vector2d extent{
      -1, 1};  // Camera::extent of the body as it was framed: at rest by the first camera, or by frame_bodies()
  Look look;

  const DisplaySettings& display() const { return simulation.scene.display; }
  void set_display(const DisplaySettings& display);

  /// Publishes positions and draws the scene into the framebuffer (resolved afterwards, panels may follow). Other
  /// `positions` than those of now: vec4, as GpuSolver::positions.
  void draw(Framebuffer& framebuffer, std::span<const GrabArrow> grabs = {}, const gl::Buffer* positions = nullptr);

  /// Once before each picture: the heat map's range, where it is not fixed, covers what was shown a frame ago here and
  /// at `beside`, which gets the same range. The first of a quantity waits for the GPU and covers what is shown now.
  void follow_range(Session* beside = nullptr) { follow_range(beside, false); }
  /// The same from the state of now, for a single picture.
  void settle_range(Session* beside = nullptr) { follow_range(beside, true); }
  void forget_range();  // the next one does not depend on what was shown before
  /// Once a frame, after its steps: the comparison with the exact step, where it is wanted, and its heat map.
  void follow_error();
  void measure_error();  // now, for a single picture
  const VisualRegions* regions() const {
    return display().color == ColorBy::region ? &*regions_ : nullptr;
  }  // null where they are not shown

  const VisualSurface& surface() const { return surface_; }
  const std::string& renderer_description() const { return description_; }
  void frame();  // camera on the bodies at rest, from the front
  /// On the bodies as they are, from where it looks: they fill this part of a picture of this shape, width over height.
  /// The ground lies below them.
  void frame_bodies(double aspect, const Eigen::Vector2d& part);
  void look_from(const CameraSettings& view);
  void measure_extent();  // of the body at rest, by the camera of now

 private:
  void lay_ground(double below);  // [m] the lowest that there is
  void show_error();
  void show_grabbed();
  void follow_range(Session* beside, bool now);
  std::optional<Eigen::Vector2d> measure_shown(bool now);

  VisualSurface surface_;
  std::optional<VisualRegions> regions_;  // once something has shown them
  std::optional<SceneRenderer> renderer_;
  std::optional<Eigen::Vector2d> shown_;  // smallest and largest value of the heat map, when last measured
  std::optional<Eigen::Vector2f> range_;  // that follows them
  std::vector<std::uint32_t> grabbed_;    // vertices that the renderer shows as held
  Eigen::Vector3d box_min_, box_max_;     // of the bodies at rest [m]
  std::string description_;
};

}  // namespace fascia
