// A stroke of the brush over the tissue: marks vertices, to be fixed or released, or tets, to be painted, when it ends.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <set>
#include <vector>

#include "app/session/session.h"

namespace fascia {

/// The picture in which the mouse acts [pixels].
struct BrushedPicture {
  int width, height;
};

class Stroke {
 public:
  enum class Marks { vertices, tets };
  /// The marks are on the tissue as it is now. `radius` [m] of the brush: vertices within it in the current shape are
  /// marked, and tets whose centroids lie within it at rest. False beside the tissue: there is no stroke.
  bool begin(const Eigen::Vector2d& at, BrushedPicture picture, Session& session, Marks marks, double radius);
  void move(const Eigen::Vector2d& at, BrushedPicture picture, const Session& session, double radius);
  /// The stroke ends: the marked vertices or tets of the model, ascending.
  std::vector<std::uint32_t> finish();
  bool under_way() const { return under_way_; }
  /// Of the marked vertices, or of the centroids of the marked tets, when the stroke began [m].
  std::vector<Eigen::Vector3d> places() const;

 private:
  void mark_vertices(const Eigen::Vector3d& point, const Model& model, double radius);
  void mark_tets(const Eigen::Vector3d& point, const Model& model, double radius);

  bool under_way_ = false;
  Marks marks_ = Marks::vertices;
  std::vector<Eigen::Vector3d> positions_;          // when the stroke began
  std::vector<Eigen::Vector3d> centroids_, rests_;  // [Model::tets] then, and at rest; empty for vertices
  std::set<std::uint32_t> marked_;
};

/// [tets] their centroids.
std::vector<Eigen::Vector3d> centroids_of(const std::vector<Tet>& tets, const std::vector<Eigen::Vector3d>& positions);

}  // namespace fascia
