#include "sim/output/state_export.h"

#include <cassert>
#include <cstdio>

#include "base/error.h"
#include "base/file.h"
#include "base/json/json_document.h"
#include "base/number_text.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/vtk/vtu_write.h"
#include "sim/mesh/linear_tets.h"
#include "sim/mesh/mesh_check.h"
#include "sim/mesh/mid_edges.h"
#include "sim/mesh/tet_faces.h"
#include "sim/output/abaqus_model.h"

namespace fascia {
namespace fs = std::filesystem;

namespace {

std::vector<Eigen::Vector3d> deformed(const TetMesh& rest, const StateFields& fields) {
  std::vector<Eigen::Vector3d> x = rest.positions;
  for (std::size_t v = 0; v < fields.displacement.size(); ++v) x[v] += fields.displacement[v];
  return x;
}

std::string vtu(const TetMesh& rest, const StateFields& fields) {
  static const std::vector<std::string_view> scalar = {""}, vector = {"x", "y", "z"},
                                             tensor = {"xx", "yy", "zz", "yz", "xz", "xy"};
  const std::vector<Eigen::Vector3d> points = deformed(rest, fields);
  std::vector<std::int32_t> regions(rest.regions.begin(), rest.regions.end());
  regions.resize(rest.tets.size(), 0);
  VtuGrid grid{points, rest.tets, rest.mid_edges, {}, {}, {}};
  const auto add = [](std::vector<VtuArray>& to, const char* name, const auto& components, const auto& values) {
    if (!values.empty()) to.push_back({name, "Float64", components, bytes_of(values)});
  };
  add(grid.point_arrays, "displacement", vector, fields.displacement);
  add(grid.point_arrays, "velocity", vector, fields.velocity);
  add(grid.point_arrays, "recovered_stress", tensor, fields.recovered_stress);
  add(grid.point_arrays, "recovered_von_mises", scalar, fields.recovered_von_mises);
  add(grid.point_arrays, "contact_force", vector, fields.contact_force);
  add(grid.point_arrays, "contact_gap", scalar, fields.contact_gap);
  add(grid.cell_arrays, "green_strain", tensor, fields.green_strain);
  add(grid.cell_arrays, "von_mises", scalar, fields.von_mises);
  add(grid.cell_arrays, "J", scalar, fields.det_f);
  grid.cell_arrays.push_back({"region", "Int32", scalar, bytes_of(regions)});
  const VtuNames names(rest);
  names.add_to(grid);
  return vtu_text(grid);
}

std::string csv(const TetMesh& rest, const StateFields& fields) {
  const std::vector<Eigen::Vector3d> points = deformed(rest, fields);
  NumberText out;
  out.add("index,x,y,z\n");
  for (std::size_t v = 0; v < points.size(); ++v) {
    out.add(v).add(',').add(points[v][0]).add(',').add(points[v][1]).add(',').add(points[v][2]).add('\n');
  }
  return out.take();
}

std::vector<Tet> usable_linear_tets(const TetMesh& mesh) {
  const MeshRepair usable = repair(mesh);
  if (mesh.mid_edges.empty()) return usable.tets;
  std::vector<MidEdges> middles;
  for (std::size_t t = 0; t < usable.tets.size(); ++t)
    middles.push_back(reordered(mesh.mid_edges[usable.source[t]], mesh.tets[usable.source[t]], usable.tets[t]));
  return linear_tets(usable.tets, middles, mesh.positions, 0, usable.tets.size()).tets;
}

void add_vertex(const Eigen::Vector3d& x, NumberText& out) {
  out.add("v ").add(x[0]).add(' ').add(x[1]).add(' ').add(x[2]).add('\n');
}

void add_face(const Triangle& numbers, NumberText& out) {
  out.add("f ").add(numbers[0]).add(' ').add(numbers[1]).add(' ').add(numbers[2]).add('\n');
}

/// The outward triangles of the usable tets, four on a face of a quadratic one, and their vertices, in the mesh's
/// order.
std::string obj(const TetMesh& rest, const StateFields& fields) {
  const std::vector<Eigen::Vector3d> points = deformed(rest, fields);
  const std::vector<Triangle> triangles = boundary_triangles(usable_linear_tets(rest));
  std::vector<std::uint32_t> number(points.size(), 0);
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t v : triangle) number[v] = 1;
  }
  NumberText out;
  std::uint32_t used = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (number[v] == 0) continue;
    number[v] = ++used;
    add_vertex(points[v], out);
  }
  for (const Triangle& t : triangles) add_face({number[t[0]], number[t[1]], number[t[2]]}, out);
  return out.take();
}

std::string tools_obj(const std::vector<ToolSurface>& tools) {
  NumberText out;
  std::uint32_t first = 1;
  for (const ToolSurface& tool : tools) {
    out.add("o ").add(on_one_line(tool.name)).add('\n');
    for (const Eigen::Vector3d& x : tool.positions) add_vertex(x, out);
    for (const Triangle& t : tool.triangles) add_face({first + t[0], first + t[1], first + t[2]}, out);
    first += static_cast<std::uint32_t>(tool.positions.size());
  }
  return out.take();
}

std::string msh(const fs::path& path, const TetMesh& rest, const StateFields& fields) {
  TetMesh mesh = rest;
  mesh.positions = deformed(rest, fields);
  return gmsh22_text(path.string(), mesh);
}

/// Standard output, or a device or pipe whose name has no extension: no files can be written beside it.
bool is_stream(const fs::path& path) {
  std::error_code ec;
  if (path == kStandardOutput) return true;
  return path.extension().empty() && fs::exists(path, ec) && !fs::is_regular_file(path, ec);
}

}  // namespace

void write_state(const fs::path& path, const TetMesh& rest, const StateFields& fields, const Provenance& provenance) {
  [[maybe_unused]] const auto fits = [](const auto& values, std::size_t count) {
    return values.empty() || values.size() == count;
  };
  assert(fits(fields.displacement, rest.positions.size()) && fits(fields.velocity, rest.positions.size()) &&
         fits(fields.recovered_stress, rest.positions.size()) &&
         fits(fields.recovered_von_mises, rest.positions.size()) && fits(fields.contact_force, rest.positions.size()) &&
         fits(fields.contact_gap, rest.positions.size()));
  assert(fits(fields.green_strain, rest.tets.size()) && fits(fields.von_mises, rest.tets.size()) &&
         fits(fields.det_f, rest.tets.size()));
  const std::string ending = lower_ending(path);
  if (is_stream(path)) {
    write_file(path, csv(rest, fields));
  } else if (ending == ".vtu") {
    write_file(path, with_provenance(vtu(rest, fields), ending, provenance));
  } else if (ending == ".csv") {
    write_file(path, csv(rest, fields));
    if (!provenance.empty())
      write_file(provenance_beside(path), "{\"provenance\":" + provenance_json(provenance) + "}\n");
  } else if (ending == ".msh") {
    write_file(path, with_provenance(msh(path, rest, fields), ending, provenance));
  } else if (ending == ".obj") {
    write_file(path, with_provenance(obj(rest, fields), ending, provenance));
  } else if (ending == ".inp") {
    TetMesh mesh = rest;
    mesh.positions = deformed(rest, fields);
    write_file(path, with_provenance(abaqus_text(mesh), ending, provenance));
  } else {
    throw Error(path.string(), "cannot be written: its ending names no export format",
                "expected .vtu, .csv, .msh, .obj or .inp");
  }
  if (fields.tools.empty() || (ending != ".vtu" && ending != ".obj")) return;
  write_file(path.parent_path() / (path.stem().string() + "_tools.obj"),
             with_provenance(tools_obj(fields.tools), ".obj", provenance));
}

void write_state(const fs::path& path, const Model& model, const StateFields& fields, const Provenance& provenance) {
  if (const std::string ending = lower_ending(path); ending == ".inp")
    write_file(path, with_provenance(abaqus_model_text(model, fields.displacement), ending, provenance));
  else
    write_state(path, model.file_mesh, fields, provenance);
}

void StateSeries::add(double time_s, const Provenance& provenance, const WriteFrame& write_frame) {
  char number[16];
  std::snprintf(number, sizeof number, "_%06zu", written_.size());
  const fs::path frame = path_.parent_path() / (path_.stem().string() + number + path_.extension().string());
  // A series of .csv files has one provenance file, beside the given name and without a time.
  const bool csv_series = lower_ending(path_) == ".csv";
  write_frame(frame, csv_series ? Provenance{} : provenance);
  if (csv_series && written_.empty() && !provenance.empty())
    write_file(provenance_beside(path_), "{\"provenance\":" + provenance_json(without_moment(provenance)) + "}\n");
  written_.emplace_back(time_s, frame.filename().string());
  if (lower_ending(path_) != ".vtu") return;

  NumberText out;
  out.add("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n");
  for (const auto& [time, name] : written_) {
    out.add("<DataSet timestep=\"").add(time).add("\" part=\"0\" file=\"").add(xml_escaped(name)).add("\"/>\n");
  }
  out.add("</Collection>\n</VTKFile>\n");
  write_file(fs::path(path_).replace_extension(".pvd"), out.take());
}

}  // namespace fascia
