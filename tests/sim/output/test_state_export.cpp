// Exports of a state: read back, and compared value by value.
#include <array>
#include <catch2/catch.hpp>
#include <fstream>
#include <limits>

#include "base/error.h"
#include "base/file.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/io/vtk/vtu_array.h"
#include "sim/mesh/mid_edges.h"
#include "sim/output/state_export.h"
#include "tests/support/meshes/samples.h"

using namespace fascia;
using namespace fascia::test;

namespace {

StateFields sample_fields() {
  StateFields fields;
  for (int v = 0; v < 6; ++v) {
    fields.displacement.push_back({0.1 * v, -1.0 / 3, 1e-17 * v});
    fields.velocity.push_back({1.0 * v, 2, 3});
    Eigen::Matrix<double, 6, 1> stress;
    stress << 10 * v, 2, 3, 4, 5, 6;
    fields.recovered_stress.push_back(stress);
    fields.recovered_von_mises.push_back(7e4 + v);
  }
  for (int t = 0; t < 2; ++t) {
    Eigen::Matrix<double, 6, 1> strain;
    strain << 1 + t, 2, 3, 4, 5, 6;
    fields.green_strain.push_back(strain);
    fields.von_mises.push_back(1e5 + t);
    fields.det_f.push_back(0.5 + t);
  }
  return fields;
}

std::vector<Eigen::Vector3d> deformed(const TetMesh& mesh, const StateFields& fields) {
  std::vector<Eigen::Vector3d> x = mesh.positions;
  for (std::size_t v = 0; v < x.size(); ++v) x[v] += fields.displacement[v];
  return x;
}

struct Array {
  std::size_t components;
  std::vector<double> values;
};

/// Arrays of PointData or CellData by name.
std::map<std::string, Array> arrays(const std::filesystem::path& path, std::string_view kind) {
  const std::string content = read_file(path);
  Scanner in(path.string(), content);
  const XmlElement root = parse_xml(in);
  const VtuArrays decoder(in, root);
  std::map<std::string, Array> out;
  for (const XmlElement& array : root.child("UnstructuredGrid")->child("Piece")->child(kind)->children) {
    out[array.attribute("Name")] = {std::stoul(array.attribute("NumberOfComponents", "1")),
                                    decoder.values<double>(array, std::nullopt)};
  }
  return out;
}

template <class Vectors>
std::vector<double> numbers_of(const Vectors& vectors) {
  std::vector<double> out;
  for (const auto& v : vectors) out.insert(out.end(), v.data(), v.data() + v.size());
  return out;
}

}  // namespace

TEST_CASE("a state as .vtu contains deformed points and every field", "[export]") {
  const TemporaryFolder folder;
  const TetMesh mesh = sample_mesh();
  const StateFields fields = sample_fields();
  write_state(folder / "state.vtu", mesh, fields);
  const MeshFile back = read_mesh(folder / "state.vtu");
  CHECK(back.mesh.positions == deformed(mesh, fields));
  CHECK(back.mesh.tets == mesh.tets);
  CHECK(back.mesh.regions == mesh.regions);

  auto points = arrays(folder / "state.vtu", "PointData");
  CHECK(back.mesh.region_names == mesh.region_names);
  CHECK(back.mesh.groups == mesh.groups);
  CHECK(points.size() == 4 + groups_beyond_regions(mesh).size());
  CHECK(points["displacement"].components == 3);
  CHECK(points["displacement"].values == numbers_of(fields.displacement));
  CHECK(points["velocity"].components == 3);
  CHECK(points["velocity"].values == numbers_of(fields.velocity));
  CHECK(points["recovered_stress"].components == 6);
  CHECK(points["recovered_stress"].values == numbers_of(fields.recovered_stress));
  CHECK(points["recovered_von_mises"].values == fields.recovered_von_mises);
  auto cells = arrays(folder / "state.vtu", "CellData");
  CHECK(cells.size() == 4);
  CHECK(cells["green_strain"].components == 6);
  CHECK(cells["green_strain"].values == numbers_of(fields.green_strain));
  CHECK(cells["von_mises"].values == fields.von_mises);
  CHECK(cells["J"].values == fields.det_f);
  CHECK(cells["region"].values == std::vector<double>{3, 7});
}

TEST_CASE("a state without optional data has no other fields", "[export]") {
  const TemporaryFolder folder;
  write_state(folder / "state.vtu", sample_mesh(), {});
  CHECK(read_mesh(folder / "state.vtu").mesh.positions == sample_mesh().positions);
  CHECK(arrays(folder / "state.vtu", "PointData").size() == groups_beyond_regions(sample_mesh()).size());
  CHECK(arrays(folder / "state.vtu", "CellData").size() == 1);
}

TEST_CASE("a state as .csv has an index and shortest digits that read back exactly", "[export]") {
  const TemporaryFolder folder;
  TetMesh mesh = sample_mesh();
  mesh.positions[1] = {0.1, 1e-300, 123456789.125};
  write_state(folder / "state.csv", mesh, {});
  CHECK(read_file(folder / "state.csv") ==
        "index,x,y,z\n0,0,0,0\n1,0.1,1e-300,123456789.125\n2,0,1,0\n3,0,0,1\n4,1,1,1.5\n5,9,8,7\n");

  const StateFields fields = sample_fields();
  write_state(folder / "state.csv", mesh, fields);
  std::ifstream in(folder / "state.csv");
  std::string line;
  std::getline(in, line);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    std::size_t index = 99;
    char comma;
    Eigen::Vector3d x;
    in >> index >> comma >> x[0] >> comma >> x[1] >> comma >> x[2];
    CHECK(index == v);
    CHECK(x == Eigen::Vector3d(mesh.positions[v] + fields.displacement[v]));
  }
}

TEST_CASE("a state as .msh is Gmsh 2.2 with regions and groups", "[export]") {
  const TemporaryFolder folder;
  const TetMesh mesh = sample_mesh();
  const StateFields fields = sample_fields();
  write_state(folder / "state.msh", mesh, fields);
  const MeshFile back = read_mesh(folder / "state.msh");
  CHECK(back.format == "Gmsh 2.2 ASCII");
  CHECK(back.mesh.positions == deformed(mesh, fields));
  CHECK(back.mesh.tets == mesh.tets);
  CHECK(back.mesh.regions == mesh.regions);
  CHECK(back.mesh.region_names == mesh.region_names);
  CHECK(back.mesh.groups == mesh.groups);
}

TEST_CASE("a state of quadratic tets as .obj has four triangles on each face, at the places of all ten nodes",
          "[export]") {
  const TemporaryFolder folder;
  TetMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tets = {{0, 2, 1, 3}};  // inside out
  add_mid_edges(mesh, {0});
  StateFields fields;
  fields.displacement.assign(10, {0, 0, 0});
  fields.displacement[mesh.mid_edges[0][0]] = {-0.1, 0, 0};
  write_state(folder / "state.obj", mesh, fields, {});
  std::ifstream in(folder / "state.obj");
  std::vector<Eigen::Vector3d> points;
  double volume = 0;
  int triangles = 0;
  for (std::string word; in >> word;) {
    Eigen::Vector3d x;
    std::array<std::size_t, 3> f{};
    if (word == "v") {
      in >> x[0] >> x[1] >> x[2];
      points.push_back(x);
    } else if (word == "f") {
      in >> f[0] >> f[1] >> f[2];
      volume += points[f[0] - 1].dot(points[f[1] - 1].cross(points[f[2] - 1])) / 6;
      ++triangles;
    }
  }
  CHECK(points.size() == 10);
  CHECK(triangles == 16);
  // The middle of the edge along y moved out of the body.
  CHECK(volume > 1.0 / 6 + 1e-3);
}

TEST_CASE("a state as .obj is the outward surface, whatever the winding of the tets", "[export]") {
  const TemporaryFolder folder;
  TetMesh mesh;
  mesh.positions = {{5, 5, 5}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  // the first is in no tet
  mesh.tets = {{1, 3, 2, 4}};                                                // negative volume
  mesh.regions = {0};
  StateFields fields;
  fields.displacement.assign(5, Eigen::Vector3d(0, 0, 2));
  write_state(folder / "state.obj", mesh, fields);

  std::ifstream in(folder / "state.obj");
  std::vector<Eigen::Vector3d> x;
  std::string kind;
  double volume6 = 0;
  std::size_t faces = 0;
  while (in >> kind) {
    if (kind == "v") {
      Eigen::Vector3d p;
      in >> p[0] >> p[1] >> p[2];
      x.push_back(p);
    } else {
      REQUIRE(kind == "f");
      std::array<std::size_t, 3> f{};
      in >> f[0] >> f[1] >> f[2];
      volume6 += x.at(f[0] - 1).dot(x.at(f[1] - 1).cross(x.at(f[2] - 1)));
      ++faces;
    }
  }
  CHECK(x == std::vector<Eigen::Vector3d>{{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {0, 0, 3}});
  CHECK(faces == 4);
  CHECK(volume6 == Approx(1));  // six times the enclosed volume, positive for outward faces
}

TEST_CASE("a series writes numbered files and lists their times", "[export]") {
  const TemporaryFolder folder;
  StateSeries series(folder / "out.vtu");
  StateFields fields = sample_fields();
  series.write(0, sample_mesh(), fields);
  const std::string first = read_file(folder / "out.pvd");
  fields.displacement[0] = {7, 7, 7};
  series.write(1.0 / 60, sample_mesh(), fields);
  CHECK(read_mesh(folder / "out_000000.vtu").mesh.positions[0] == Eigen::Vector3d(0, -1.0 / 3, 0));
  CHECK(read_mesh(folder / "out_000001.vtu").mesh.positions[0] == Eigen::Vector3d(7, 7, 7));

  const std::string head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  const std::string frame_0 = "<DataSet timestep=\"0\" part=\"0\" file=\"out_000000.vtu\"/>\n";
  const std::string frame_1 = "<DataSet timestep=\"0.016666666666666666\" part=\"0\" file=\"out_000001.vtu\"/>\n";
  const std::string tail = "</Collection>\n</VTKFile>\n";
  CHECK(first == head + frame_0 + tail);  // a series that ends here can be read
  CHECK(read_file(folder / "out.pvd") == head + frame_0 + frame_1 + tail);

  StateSeries csv(folder / "frames.csv");
  csv.write(0, sample_mesh(), fields);
  CHECK(std::filesystem::exists(folder / "frames_000000.csv"));
  CHECK_FALSE(std::filesystem::exists(folder / "frames.pvd"));
}

TEST_CASE("exports that cannot be written report the reason", "[export]") {
  const TemporaryFolder folder;
  const std::string prefix = folder.path().string() + "/";
  CHECK_THROWS_WITH(
      write_state(folder / "state.xyz", sample_mesh(), {}),
      prefix +
          "state.xyz: cannot be written: its ending names no export format; expected .vtu, .csv, .msh, .obj or .inp");
  CHECK_THROWS_WITH(write_state(folder / "none/state.csv", sample_mesh(), {}),
                    prefix + "none/state.csv: no such folder " + prefix + "none; expected an existing folder");
  StateSeries series(folder / "none/out.vtu");
  CHECK_THROWS_AS(series.write(0, sample_mesh(), {}), Error);
}

TEST_CASE("a state in contact has forces and gaps at its vertices, and its tools in a file beside", "[export]") {
  const TemporaryFolder folder;
  const TetMesh mesh = sample_mesh();
  StateFields fields = sample_fields();
  for (int v = 0; v < 6; ++v) {
    fields.contact_force.push_back({1.0 * v, -2, 1.0 / 3});
    fields.contact_gap.push_back(v == 0 ? std::numeric_limits<double>::quiet_NaN() : 1e-3 * v);
  }
  fields.tools = {{"ground", {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, 1, 2}}},
                  {"probe\nof two lines", {{0, 1, 0}, {1, 1, 0}, {0, 1, -0.1}}, {{0, 1, 2}}}};
  write_state(folder / "state.vtu", mesh, fields, {{"Software", "fascia"}});
  auto points = arrays(folder / "state.vtu", "PointData");
  CHECK(points["contact_force"].components == 3);
  CHECK(points["contact_force"].values == numbers_of(fields.contact_force));
  REQUIRE(points["contact_gap"].values.size() == 6);
  CHECK(std::isnan(points["contact_gap"].values[0]));
  CHECK(points["contact_gap"].values[5] == 5e-3);
  CHECK(read_file(folder / "state_tools.obj") ==
        "# fascia: {\"Software\":\"fascia\"}\n"
        "o ground\nv 0 0 0\nv 1 0 0\nv 0 0 -1\nf 1 2 3\n"
        "o \"probe\\nof two lines\"\nv 0 1 0\nv 1 1 0\nv 0 1 -0.1\nf 4 5 6\n");
  write_state(folder / "other.csv", mesh, fields);
  CHECK_FALSE(std::filesystem::exists(folder / "other_tools.obj"));
}
