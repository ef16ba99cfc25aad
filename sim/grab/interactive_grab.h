// One grab: springs from a patch of tissue to where it is led. How stiff the springs are follows from the tissue, how
// far and how fast they may lead follows from its size, so that a grab neither slips off soft tissue nor tears stiff
// one.
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
  bool push = false;             // a press pushes into the surface instead of taking it along
  bool stay = false;             // grabs stay where they are released
  bool operator==(const GrabSettings&) const = default;
};

class Grab {
 public:
  /// Takes hold of the free vertices around the hit point, of one body, in `positions` as deformed now (those of
  /// `surface`, mesh vertices first). With settings.push it at once presses half the patch's radius deep. False, and
  /// nothing held, where all of them are fixed or prescribed.
  bool take(const Model& model, const VisualSurface& surface, std::span<const Eigen::Vector3d> positions,
            const Hit& hit, double scene_radius, const GrabSettings& settings);
  void release() { *this = Grab(); }
  bool holding() const { return !patch_.empty(); }
  /// The same grab with a larger or smaller patch, around the same point of the tissue as it was taken. It stays as it
  /// is where no free vertex is within the new one.
  void set_size(const Model& model, const GrabSettings& settings);

  /// The mouse: where its ray meets the plane through the grab that faces the viewer.
  void point_at(const Ray& ray, const Eigen::Vector3d& forward);
  /// Away from the viewer by `depth` [m] or, when it pushes, deeper into the surface as it was.
  void go_deeper(double depth, const Eigen::Vector3d& forward);
  /// Where it is led to is where the patch is: for a grab that is taken up again.
  void plane_here() { plane_ = pointer_; }

  /// Springs of the next step. Their targets move towards the pointer, but not faster and not farther than tissue can
  /// follow.
  std::vector<GrabSpring> springs(double time_step, std::uint32_t grab = 0);
  /// The force that the last springs had [N] (Diagnostics::grab_forces): says how far the patch has followed.
  void observe(const Eigen::Vector3d& force);

  double stiffness() const { return stiffness_; }  // of all springs together [N/m]
  double patch_radius() const { return radius_; }  // [m]
  bool pushes() const { return push_; }
  const Eigen::Vector3d& force() const { return force_; }      // as observed [N]
  const Eigen::Vector3d& pointer() const { return pointer_; }  // where it is led to [m]
  Eigen::Vector3d target() const { return start_ + offset_; }  // where the springs pull the held point to [m]
  Eigen::Vector3d anchor() const { return target() - force_ / stiffness_; }  // where the held point is [m]
  std::vector<std::uint32_t> vertices() const;

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
  Eigen::Vector3d inward_{0, 0, 0};  // of the surface when taken
  Eigen::Vector3d start_{0, 0, 0}, plane_{0, 0, 0}, pointer_{0, 0, 0}, offset_{0, 0, 0}, force_{0, 0, 0};
};

}  // namespace fascia
