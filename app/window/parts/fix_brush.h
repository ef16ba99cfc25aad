// A brush that marks vertices on the tissue, to be fixed or released when the stroke ends.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <set>
#include <vector>

#include "app/session/session.h"

namespace fascia {

class FixBrush {
 public:
  struct Picture {
    int width, height;
  };
  /// A stroke begins; its marks are on the tissue as it is now. `radius` [m] is that of the brush. False beside the
  /// tissue: there is no stroke.
  bool begin(const Eigen::Vector2d& at, Picture picture, Session& session, double radius);
  void move(const Eigen::Vector2d& at, Picture picture, const Session& session, double radius);
  /// The stroke ends: the marked vertices of the model, ascending.
  std::vector<std::uint32_t> finish();
  bool painting() const { return painting_; }
  std::vector<Eigen::Vector3d> places() const;  // of the marked vertices, when the stroke began [m]

 private:
  bool painting_ = false;
  std::vector<Eigen::Vector3d> positions_;  // when the stroke began
  std::set<std::uint32_t> marked_;
};

}  // namespace fascia
