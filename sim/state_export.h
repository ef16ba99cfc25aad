// Exports of a simulated state in the file's vertex and tet order: .vtu, .csv, .msh, .obj, and .pvd time
// series.
#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "sim/provenance.h"
#include "sim/tet_mesh.h"

namespace fascia {

/// What is known of a moment. Vertex arrays are [mesh.positions.size()], tet arrays [mesh.tets.size()].
struct StateFields {
  std::vector<Eigen::Vector3d> displacement;              // [m]
  std::vector<Eigen::Vector3d> velocity;                  // [m/s]
  std::vector<Eigen::Matrix<double, 6, 1>> green_strain;  // xx, yy, zz, yz, xz, xy, tensor shears [-]
  std::vector<double> von_mises;                          // of the Cauchy stress [Pa]
  std::vector<double> det_f;                              // J [-], exported as "J"
};

/// Format by ending; standard output ("-") and a device get .csv, without what made it. .csv is `index,x,y,z` of deformed positions with shortest round-trip digits; .obj is the
/// surface. .msh is Gmsh 2.2 ASCII with deformed positions. Temporary name and rename; throws Error. What made it goes with it
/// (sim/provenance.h).
inline const std::vector<std::string> state_endings{".vtu", ".csv", ".msh", ".obj"};
void write_state(const std::filesystem::path& path, const TetMesh& rest, const StateFields& fields, const Provenance& provenance = {});

/// Numbered files and one .pvd that lists them with their times, rewritten after every frame so that an
/// interrupted run leaves a readable series. For endings other than .vtu only the numbered files are written.
class StateSeries {
 public:
  explicit StateSeries(std::filesystem::path path) : path_(std::move(path)) {}  // "out.vtu" -> out_000000.vtu, out.pvd
  void write(double time_s, const TetMesh& rest, const StateFields& fields, const Provenance& provenance = {});

 private:
  std::filesystem::path path_;
  std::vector<std::pair<double, std::string>> written_;
};

}  // namespace fascia
