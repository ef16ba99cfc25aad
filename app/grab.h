// The hand: springs from a patch of tissue to the mouse. How stiff the springs are follows from the tissue, how far and how fast
// they may lead follows from its size, so that a hand neither slips off soft tissue nor tears stiff one.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "app/pick.h"
#include "render/look.h"
#include "sim/gpu/grab_springs.h"
#include "sim/model.h"

namespace fascia {

struct GrabSettings {
  double radius = 0.08;  // of the patch, as a share of the scene's radius
  double grip = 3;       // springs of the whole patch together over E * patch radius: a thick body indented by a disc has 2
};

class Grab {
 public:
  /// Takes hold of the free vertices around the hit point, of one body, in `positions` as deformed now (mesh vertices first).
  /// False, and nothing held, where all of them are fixed or prescribed.
  bool take(const Model& model, std::span<const Eigen::Vector3d> positions, const Triangle& triangle, const Hit& hit,
            double scene_radius, const GrabSettings& settings);
  void release() { *this = Grab(); }
  bool holding() const { return !patch_.empty(); }

  /// The mouse: where its ray meets the plane through the held point that faces the viewer.
  void point_at(const Ray& ray, const Eigen::Vector3d& forward);
  /// Springs of the next step. Their targets move towards the mouse, but not faster and not farther than tissue can follow.
  std::vector<GrabSpring> springs(double time_step);
  /// The force that the last springs had [N] (Diagnostics::grab_force): says how far the patch has followed.
  void observe(const Eigen::Vector3d& force);

  double stiffness() const { return stiffness_; }             // of all springs together [N/m]
  const Eigen::Vector3d& force() const { return force_; }     // as observed [N]
  const Eigen::Vector3d& pointer() const { return pointer_; }  // where the mouse is [m]
  Eigen::Vector3d target() const { return start_ + offset_; }  // where the springs pull the held point to [m]
  Eigen::Vector3d anchor() const { return target() - force_ / stiffness_; }  // where the held point is [m]
  std::vector<std::uint32_t> vertices() const;
  GrabMark mark() const;

 private:
  struct Grip {
    std::uint32_t vertex;
    Eigen::Vector3d displacement;  // when taken [m]
    double stiffness;              // [N/m]
  };
  std::vector<Grip> patch_;
  double stiffness_ = 1, reach_ = 0;  // [N/m], [m] lead that the springs may have
  Eigen::Vector3d start_{0, 0, 0}, pointer_{0, 0, 0}, offset_{0, 0, 0}, force_{0, 0, 0};
};

}  // namespace fascia
