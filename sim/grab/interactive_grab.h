// One grab: springs from a patch of tissue to a target that the user moves. The stiffness of the springs follows from
// the tissue, their range and speed from its size, so that a grab neither slips off soft tissue nor tears stiff tissue.
#pragma once
#include <span>
#include <vector>

#include "sim/grab/grab_patch.h"
#include "sim/model/grab_spring.h"
#include "sim/visual/picking.h"
#include "sim/visual/visual_surface.h"

namespace fascia {

struct GrabSettings {
  double radius = kPatchRadius;  // of the patch, as a share of the scene's radius
  double grip = kGrip;           // springs of the whole patch together over E * patch radius
  bool push = false;             // a press indents the surface instead of pulling it along
  bool stay = false;             // grabs stay where they are released
  bool operator==(const GrabSettings&) const = default;
};

class Grab {
 public:
  /// Grabs the free vertices around the hit point, of one body, in the currently deformed `positions` (those of
  /// `surface`, mesh vertices first). With settings.push the grab at once presses half the patch's radius deep. False,
  /// without a grab, if all of them are fixed or prescribed.
  bool take(const Model& model, const VisualSurface& surface, std::span<const Eigen::Vector3d> positions,
            const Hit& hit, double scene_radius, const GrabSettings& settings);
  void release() { *this = Grab(); }
  bool holding() const { return !patch_.empty(); }
  /// The same grab with a larger or smaller patch, around the original point of the tissue. Unchanged if no free vertex
  /// is within the new patch.
  void set_size(const Model& model, const GrabSettings& settings);

  /// Moves the target to the intersection of the mouse's ray with the plane through the grab that faces the viewer.
  void point_at(const Ray& ray, const Eigen::Vector3d& forward);
  /// Moves the target away from the viewer by `depth` [m] or, when pushing, deeper into the original surface.
  void go_deeper(double depth, const Eigen::Vector3d& forward);
  /// Moves the plane to the patch, for a grab that is taken up again.
  void plane_here() { plane_ = pointer_; }

  /// Springs of the next step. Their targets move towards the pointer, but no faster and no farther than the tissue can
  /// follow.
  std::vector<GrabSpring> springs(double time_step, std::uint32_t grab = 0);
  /// The force of the last springs [N] (Diagnostics::grab_forces), which shows how far the patch has followed.
  void observe(const Eigen::Vector3d& force);

  double stiffness() const { return stiffness_; }  // of all springs together [N/m]
  double patch_radius() const { return radius_; }  // [m]
  bool pushes() const { return push_; }
  const Eigen::Vector3d& force() const { return force_; }      // as observed [N]
  const Eigen::Vector3d& pointer() const { return pointer_; }  // the target that the user sets [m]
  Eigen::Vector3d target() const { return start_ + offset_; }  // where the springs pull the grabbed point to [m]
  Eigen::Vector3d anchor() const { return target() - force_ / stiffness_; }  // where the grabbed point is [m]
  std::vector<std::uint32_t> vertices() const;
  /// A grab of a scene that pulls the same point of the tissue to the same place, from the start on.
  ScriptedGrab as_scripted(const Model& model) const;

 private:
  bool grip(const Model& model, const GrabSettings& settings);  // false, and nothing changes: no free vertex

  struct Grip {
    std::uint32_t vertex;
    Eigen::Vector3d displacement;  // when taken [m]
    double stiffness;              // [N/m]
  };
  std::vector<Grip> patch_;
  std::vector<Eigen::Vector3d> taken_;                    // positions of the mesh vertices when taken [m]
  EmbeddedPoint place_{};                                 // of the hit point
  double stiffness_ = 1, radius_ = 0, scene_radius_ = 1;  // [N/m], [m], [m]
  bool push_ = false;
  Eigen::Vector3d inward_{0, 0, 0};  // of the surface at the start of the grab
  Eigen::Vector3d start_{0, 0, 0}, plane_{0, 0, 0}, pointer_{0, 0, 0}, offset_{0, 0, 0}, force_{0, 0, 0};
};

}  // namespace fascia
