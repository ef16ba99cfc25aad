// How far a tool is from tissue at the least: balls around the faces of its surface, or around parts of them.
#pragma once
#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "sim/model/model.h"

namespace fascia {

/// Of the size of the tissue: points closer to a tool may touch it in a step in which they were expected to rest.
inline constexpr double kContactMargin = 0.02;

class TissueCover {
 public:
  /// `radius` [m] of the balls, at most where an eighth of a face is as small.
  TissueCover(const Model& model, double radius);

  /// `positions`: of the model's vertices, possibly followed by others [m].
  void follow(std::span<const Eigen::Vector3d> positions);
  double size() const { return box_.diagonal().norm(); }  // [m] of the tissue as of follow()
  /// The distance of the tool from the tissue [m], or less. Far away it takes the box around the tissue.
  double clearance(const Tool& tool, const ToolPlace& place) const;
  /// Whether a tool that moves from one place to the other in a step may touch the tissue, which is at rest. False for
  /// a tool that does not move, wherever it is.
  bool is_met_by(const Tool& tool, const ToolPlace& from, const ToolPlace& to) const;

 private:
  struct Ball {
    Eigen::Vector3d center;
    double radius;
  };
  double radius_, half_thickness_;  // [m]
  std::vector<Triangle> faces_;
  std::vector<Ball> balls_;
  Eigen::AlignedBox3d box_;
};

}  // namespace fascia
