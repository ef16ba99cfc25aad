// Exports of a simulated state in the file's vertex and tet order: .vtu, .csv, .msh, .obj, .inp, and .pvd time
// series.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/provenance.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/model/model.h"
#include "sim/model/state_fields.h"

namespace fascia {

/// The format follows from the extension; standard output ("-") and a device get .csv, without provenance. .csv is
/// `index,x,y,z` of deformed positions with shortest round-trip digits; .obj is the surface. .msh is Gmsh 2.2 ASCII
/// with deformed positions, and so is .inp. Tools are written beside a .vtu or .obj, as NAME_tools.obj with an object
/// for each. Writes a temporary file and renames it; throws Error. The provenance is included (base/provenance.h).
inline const std::vector<std::string> state_endings{".vtu", ".csv", ".msh", ".obj", ".inp"};
void write_state(const std::filesystem::path& path, const TetMesh& rest, const StateFields& fields,
                 const Provenance& provenance = {});
/// The same of a model's state; .inp with the materials, and the held vertices as sets (sim/output/abaqus_model.h).
void write_state(const std::filesystem::path& path, const Model& model, const StateFields& fields,
                 const Provenance& provenance = {});

/// Numbered files and one .pvd that lists them with their times. The .pvd is rewritten after every frame, so that an
/// interrupted run leaves a readable series. For extensions other than .vtu only the numbered files are written.
class StateSeries {
 public:
  explicit StateSeries(std::filesystem::path path) : path_(std::move(path)) {}  // "out.vtu" -> out_000000.vtu, out.pvd
  void write(double time_s, const TetMesh& rest, const StateFields& fields, const Provenance& provenance = {}) {
    add(time_s, provenance, [&](const auto& frame, const Provenance& of) { write_state(frame, rest, fields, of); });
  }
  void write(double time_s, const Model& model, const StateFields& fields, const Provenance& provenance = {}) {
    add(time_s, provenance, [&](const auto& frame, const Provenance& of) { write_state(frame, model, fields, of); });
  }

 private:
  using WriteFrame = std::function<void(const std::filesystem::path&, const Provenance&)>;
  void add(double time_s, const Provenance& provenance, const WriteFrame& write_frame);

  std::filesystem::path path_;
  std::vector<std::pair<double, std::string>> written_;
};

}  // namespace fascia
