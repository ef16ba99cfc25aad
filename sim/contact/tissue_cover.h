// How far a tool is from tissue at the least: balls around the faces of its surface, or around parts of them.
#pragma once
#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "sim/model/model.h"

namespace fascia {

class TissueCover {
 public:
  /// `radius` [m] of the balls, at most where an eighth of a face is as small.
  TissueCover(const Model& model, double radius);

  /// `positions`: of the model's vertices, possibly followed by others [m].
  void follow(std::span<const Eigen::Vector3d> positions);
  double size() const { return box_.diagonal().norm(); }  // [m] of the tissue as of follow()
  /// The distance of the tool from the tissue [m], or less. Far away it takes the box around the tissue.
  double clearance(const Tool& tool, const ToolPlace& place) const;

 private:
  struct Ball {
    Eigen::Vector3d center;
    double radius;
  };
  double radius_;
  std::vector<Triangle> faces_;
  std::vector<Ball> balls_;
  Eigen::AlignedBox3d box_;
};

}  // namespace fascia
