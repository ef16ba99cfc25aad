// Builds the cases of the stress suite: a beam, its scene, and initial states.
#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/stress/stress.h"
#include "sim/material/tissues.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/model/state.h"

namespace fascia {

inline constexpr double kBarLength = 0.4, kBarWidth = 0.2;                                // of the beam [m]
inline const double kBarSize = Eigen::Vector3d(kBarLength, kBarWidth, kBarWidth).norm();  // [m]
inline constexpr double kNearFace = 1e-6;                                                 // [m]

struct StressCases {
  SolverChoice pair;
  MaterialModel model;
  Integrator integrator;
  ElementOrder elements;
  std::filesystem::path folder;
  bool quick;
  std::vector<StressCase> cases = {};
  std::map<std::string, std::uint64_t> meshes = {};  // hashes of those written, by name

  TetMesh beam(double length = kBarLength) const;
  /// A scene of one body: tissue of 1 MPa, clamped at x = 0 unless it is free, no gravity. Cases are run after all of
  /// them were made: throws std::logic_error for the name of another mesh.
  Scene scene(const std::string& mesh_name, const TetMesh& mesh, bool clamped = true);
  Scene beam_scene(bool clamped = true) { return scene("beam", beam(), clamped); }
  SolverSettings solver() const;
  /// At rest at the places that `place` gives the vertices; those at x = 0 stay at the support of a clamped body.
  std::optional<State> start(const Scene& scene,
                             const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& place) const;
  std::optional<State> bent(const Scene& scene) const;
  StressCase& add(const std::string& group, const std::string& name, Scene scene, std::optional<State> state,
                  long steps);
};

/// Springs on the vertices near the free end of a beam, as a grab creates them: together as stiff as tissue indented by
/// a disc.
GrabInput grip_end(const Model& built, const Eigen::Vector3d& offset);

/// "1e+06"
std::string in_short(double value);

}  // namespace fascia
