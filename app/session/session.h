// Connects simulation and drawing: the only code that passes the solver's buffers to the renderer.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/session/graphics.h"
#include "render/scene_renderer.h"
#include "render/target/framebuffer.h"
#include "render/view/camera.h"
#include "sim/gpu/readback/lowest_point.h"
#include "sim/grab/build_model.h"
#include "sim/simulation/errors/true_error.h"
#include "sim/simulation/recovered_map.h"
#include "sim/simulation/simulation.h"
#include "sim/visual/shape_mesh.h"
#include "sim/visual/visual_regions.h"
#include "sim/visual/visual_surface.h"

namespace fascia {

class Session {
 public:
  /// Throws Error; a window then keeps its current session.
  Session(Graphics& graphics, Scene scene, Model built, bool use_reference,
          const Progress& progress = {});  // build_model(scene)
  Session(Graphics& graphics, const Scene& scene, bool use_reference)
      : Session(graphics, scene, build_model(scene), use_reference) {}

  Simulation simulation;
  TrueError true_error;
  bool follow_true_error = false;  // measurements in immediate succession
  RecoveredMap recovered;
  Camera camera;
  Eigen::Vector2d extent{
      -1, 1};  // Camera::extent of the body when it was framed: at rest by the first camera, or by frame_bodies()
  Look look;
  std::optional<std::size_t> highlighted;  // tool of the model

  const DisplaySettings& display() const { return simulation.scene.display; }
  void set_display(const DisplaySettings& display);

  /// Publishes positions and draws the scene into the framebuffer (resolved afterwards, panels may follow). `positions`
  /// replaces the current ones: vec4, as GpuSolver::positions.
  void draw(Framebuffer& framebuffer, std::span<const GrabArrow> grabs = {}, const gl::Buffer* positions = nullptr);

  /// Call once before each picture: an automatic range of the heat map follows the values shown one frame ago here and
  /// in `beside`, which gets the same range. The first picture of a quantity waits for the GPU and follows its own
  /// values.
  void follow_range(Session* beside = nullptr) { follow_range(beside, false); }
  /// The same from the current state, for a single picture.
  void settle_range(Session* beside = nullptr) { follow_range(beside, true); }
  /// False while an automatic range has met no value to follow, as at rest: the colors mean nothing then.
  bool has_range() const { return display().range || range_; }
  void forget_range();            // makes the next range independent of earlier pictures
  bool range_only_grows = false;  // for a video, whose colors must keep their meaning
  /// Whether values lie below and above the range of the colors, as of the last call of follow_range or settle_range.
  std::array<bool, 2> beyond_range() const;
  /// Call as follow_range: the ground stays below the lowest point of one frame ago, here and in `beside`. Without a
  /// drawn ground it does nothing.
  void follow_ground(Session* beside = nullptr) { follow_ground(beside, false); }
  void settle_ground(Session* beside = nullptr) { follow_ground(beside, true); }
  /// Simulation::set_material_entries(), after which nothing here reads the buffers of the replaced solver.
  void set_material_entries(const std::vector<MaterialEntries>& entries);
  void forget_ground();  // puts the ground below the bodies at rest again
  /// The same with settle_ground(), for a window whose tissue has come to rest: the ground that sank below a body
  /// returns with it.
  void lift_ground(Session* beside = nullptr);
  /// Call once per frame, after its steps: updates the comparison with the exact step, if requested, and the heat maps
  /// of errors.
  void follow_error();
  void measure_error();  // the shown one at once, for a single picture; without the heat map of an error nothing
  bool measuring_error() const { return true_error.busy() || recovered.busy(); }
  void forget_errors();  // the state has jumped
  const VisualRegions* regions() const {
    return display().color == ColorBy::region ? &*regions_ : nullptr;
  }  // null if they are not shown

  const VisualSurface& surface() const { return surface_; }
  const std::string& renderer_description() const { return description_; }
  /// Points the camera from the front at the bodies at rest, and at those instruments as they start beside which the
  /// bodies keep half of their size in the picture.
  void frame();
  /// Frames the current bodies from the camera's direction: they fill this part of a picture of this aspect ratio,
  /// width over height. The ground is placed below them.
  void frame_bodies(double aspect, const Eigen::Vector2d& part);
  /// Frames the bodies at rest together with their current positions, if these left the space that frame() shows.
  void frame_with_motion();
  void look_from(const CameraSettings& view);
  void measure_extent();  // of the body at rest, for the current camera

 private:
  void lay_ground(double below);  // [m] lowest point
  void follow_ground(Session* beside, bool now);
  void measure_lowest(bool now);  // lowers the ground
  void show_error();
  void show_grabbed();
  void show_tools();
  void show_paints();
  bool needs_regions() const;  // of triangles
  void follow_range(Session* beside, bool now);
  std::optional<ShownValues> measure_shown(bool now);

  VisualSurface surface_;
  std::optional<VisualRegions> regions_;  // created when first shown
  std::optional<SceneRenderer> renderer_;
  std::optional<ShownValues> shown_;      // of the heat map at the last measurement
  std::optional<ShownValues> compared_;   // shown_ together with those of the session beside
  std::optional<Eigen::Vector2f> range_;  // follows compared_
  std::optional<LowestPoint> lowest_;     // created when the ground is first shown
  double laid_ground_ = 0;                // [m] height of the ground before it followed the bodies
  bool stands_ = false;                   // on the ground, held at its lowest part; else it hangs above the ground
  std::vector<std::uint32_t> grabbed_;    // vertices that the renderer shows as grabbed
  std::vector<TissuePaint> paints_;       // that the renderer has
  std::vector<ShapeMesh> tool_meshes_;    // [tool]
  std::vector<ToolPlace> shown_places_;   // at which the renderer shows them
  std::optional<std::size_t> shown_highlight_;
  Eigen::Vector3d box_min_, box_max_;  // of the bodies at rest [m]
  std::string description_;
};

}  // namespace fascia
