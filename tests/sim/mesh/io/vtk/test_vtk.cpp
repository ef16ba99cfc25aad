// Features of VTK files only: arrays that may contain regions, pieces, several layouts, and their specific errors.
// Covers: vtk_legacy, vtu, vtu_array, sim/mesh/io/xml
#include <catch2/catch.hpp>

#include "sim/mesh/io/formats.h"
#include "tests/support/meshes/samples.h"

using namespace fascia;
using namespace fascia::test;

namespace {

std::string vtk_error(const std::string& from, const std::string& to) {
  return error_of("m.vtk", replaced(sample_content("old_text.vtk"), from, to));
}
std::string vtu_error(const std::string& from, const std::string& to) {
  return error_of("m.vtu", replaced(sample_content("text.vtu"), from, to));
}

std::vector<int> regions_of_array(const std::string& name, const std::string& type, const std::string& values) {
  std::string text = replaced(sample_content("old_text.vtk"), "SCALARS Material int", "SCALARS " + name + " " + type);
  text = replaced(text, "1 5 11 3 7", values);
  return read_mesh_content("m.vtk", text).mesh.regions;
}

}  // namespace

TEST_CASE("VTK: cell arrays that contain regions", "[mesh_io]") {
  for (const std::string name : {"region", "Material", "MaterialIds", "CellEntityIds", "gmsh:physical", "medit:ref"}) {
    INFO(name);
    CHECK(regions_of_array(name, "int", "1 5 11 3 7") == std::vector<int>{3, 7});
  }
  CHECK(regions_of_array("pressure", "int", "1 5 11 3 7") == std::vector<int>{0, 0});
  CHECK(regions_of_array("region", "double", "1 5 11 3.0 7e0") == std::vector<int>{3, 7});
  CHECK(regions_of_array("region", "double", "1 5 11 3.5 7") == std::vector<int>{0, 0});
  CHECK(regions_of_array("region", "double", "1 5 11 nan 1e300") == std::vector<int>{0, 0});

  // the more specific name is preferred, wherever it is
  const std::string both = replaced(sample_content("old_text.vtk"), "POINT_DATA",
                                    "SCALARS region int\nLOOKUP_TABLE default\n1 2 3 4 5\nPOINT_DATA");
  const MeshFile file = read_mesh_content("m.vtk", both);
  CHECK(file.mesh.regions == std::vector<int>{4, 5});
  CHECK(file.notes == std::vector<std::string>{"Regions are those of the cell array 'region'."});
}

TEST_CASE("VTK: higher order, other cells, other attributes", "[mesh_io]") {
  std::string text = "# vtk DataFile Version 3.0\nt\nascii\ndataset unstructured_grid\npoints 10 float\n";
  for (int i = 0; i < 10; ++i) text += std::to_string(i) + " 0 0\n";
  text += "cells 3 22\n10 0 1 2 3 4 5 6 7 8 9\n4 0 1 2 3\n5 0 1 2 3 4\ncell_types 3\n24\n9\n14\n";
  text += "CELL_DATA 3\nVECTORS v float\n1 2 3 4 5 6 7 8 9\nTENSORS t float\n" +
          std::string(27 * 2, '1').replace(0, 54, [] {
            std::string ones;
            for (int i = 0; i < 27; ++i) ones += "1 ";
            return ones;
          }());
  text +=
      "\nTEXTURE_COORDINATES c 2 float\n1 2 3 4 5 6\nCOLOR_SCALARS rgb 3\n0 0 0 1 1 1 0 0.5 0\nLOOKUP_TABLE own 2\n0 0 "
      "0 1\n1 1 1 1\n";
  const MeshFile file = read_mesh_content("m.vtk", text);
  CHECK(file.mesh.tets == std::vector<Tet>{{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 2, 3, 4}});
  CHECK(file.ignored.polygons == 1);
  CHECK(file.notes == std::vector<std::string>{kHigherOrderNote, "1 pyramid split into 2 tets."});
}

TEST_CASE("VTK legacy: bad files", "[mesh_io]") {
  CHECK(vtk_error("ASCII", "ASCI") == "m.vtk:3: encoding is 'ASCI'; expected ASCII or BINARY");
  CHECK(vtk_error("UNSTRUCTURED_GRID", "STRUCTURED_GRID") ==
        "m.vtk:4: dataset is 'STRUCTURED_GRID'; expected UNSTRUCTURED_GRID or POLYDATA; ParaView opens it and saves "
        "its mesh as .vtu");
  CHECK(vtk_error("UNSTRUCTURED_GRID", "POLYDATA") ==
        "m.vtk:8: keyword is 'CELLS'; expected POINTS, POLYGONS, TRIANGLE_STRIPS, LINES, VERTICES, CELL_DATA, "
        "POINT_DATA or an attribute");
  CHECK(vtk_error("POINTS 6", "POINTS 1000000000000") ==
        "m.vtk:5: POINTS: claims 1000000000000 points but only 368 bytes follow; expected a complete file");
  CHECK(vtk_error("POINTS 6 double", "POINTS 6 real") ==
        "m.vtk:5: POINTS: data type is 'real'; expected a number type such as float, double or int");
  CHECK(vtk_error("9 8 7", "9 nan 7") == "m.vtk:7: POINTS: a point coordinate is nan; expected a finite number");
  CHECK(vtk_error("9 8 7", "9 8") == "m.vtk:8: POINTS: a point coordinate is 'CELLS'; expected a number");
  CHECK(vtk_error("CELLS 5 19", "CELLS 5 1000000000000") ==
        "m.vtk:8: CELLS: claims 1000000000000 numbers but only 312 bytes follow; expected a complete file");
  CHECK(vtk_error("CELLS 5 19", "CELLS 5 18") ==
        "m.vtk:13: CELLS: cell 4 has 4 points; expected at most the 4 numbers left of the list");
  CHECK(vtk_error("CELLS 5 19", "CELLS 5 20") == "m.vtk:13: CELLS: cells take 19 numbers; expected 20");
  CHECK(vtk_error("4 1 2 3 4", "4 1 2 3 6") == "m.vtk:8: CELLS: cell 4 names point 6; expected 0 to 5");
  CHECK(vtk_error("4 1 2 3 4", "4 1 2 3 -1") == "m.vtk:8: CELLS: cell 4 names point -1; expected 0 to 5");
  CHECK(vtk_error("10\n10\n", "10\n5\n") == "m.vtk:8: CELLS: cell 4 of type 5 has 4 points; expected 3");
  CHECK(vtk_error("CELL_TYPES 5", "CELL_TYPES 4") ==
        "m.vtk:18: CELL_TYPES: 4 cell types for 5 cells; expected one for each");
  CHECK(vtk_error("CELL_DATA 5", "CELL_DATA 6") == "m.vtk:20: CELL_DATA: is for 6 cells; expected 5");
  CHECK(vtk_error("CELL_DATA 5", "CELL_DATUM 5") ==
        "m.vtk:20: keyword is 'CELL_DATUM'; expected POINTS, CELLS, CELL_TYPES, CELL_DATA, POINT_DATA or an attribute");
  CHECK(error_of("m.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n") ==
        "m.vtk:5: has no points; expected POINTS");
  CHECK(error_of("m.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 1 float\n1 2 3\n") ==
        "m.vtk:7: has no cells; expected CELLS and CELL_TYPES");

  std::string binary = sample_content("new_binary.vtk");
  const std::size_t points = binary.find("POINTS 6 double\n") + 16;
  binary.replace(points + 8, 8, Bytes(true).add(std::nan("")).text);
  CHECK(error_of("m.vtk", binary) ==
        "m.vtk: byte " + std::to_string(points) + ", POINTS: coordinate y of point 0 is nan; expected a finite number");
  binary = sample_content("new_binary.vtk");
  const std::size_t offsets = binary.find("OFFSETS vtktypeint64\n") + 21;
  binary.replace(offsets + 8, 8, Bytes(true).add(std::int64_t{1} << 60).text);
  CHECK(error_of("m.vtk", binary).ends_with("cell 0 ends at offset 1152921504606846976; expected 0 to 14"));
}

TEST_CASE("VTU: two pieces make one mesh", "[mesh_io]") {
  const std::string one = sample_content("text.vtu");
  const std::size_t begin = one.find("<Piece"), end = one.find("</UnstructuredGrid>");
  const std::string piece = one.substr(begin, end - begin);
  const TetMesh mesh = read_mesh_content("m.vtu", one.substr(0, end) + piece + one.substr(end)).mesh;
  CHECK(mesh.positions.size() == 12);
  CHECK(mesh.tets == std::vector<Tet>{{0, 1, 2, 3}, {1, 2, 3, 4}, {6, 7, 8, 9}, {7, 8, 9, 10}});
  CHECK(mesh.regions == std::vector<int>{3, 7, 3, 7});
}

TEST_CASE("VTU: bad XML and attributes", "[mesh_io]") {
  CHECK(vtu_error("type=\"UnstructuredGrid\"", "type=\"ImageData\"") ==
        "m.vtu:3: VTKFile: type is 'ImageData'; expected UnstructuredGrid or PolyData; 3D Slicer imports it as a "
        "segmentation and exports a surface as .stl, .ply or .obj");
  CHECK(vtu_error("LittleEndian", "Middle") ==
        "m.vtu:3: VTKFile: byte_order is 'Middle'; expected LittleEndian or BigEndian");
  CHECK(vtu_error("UInt64", "UInt16") == "m.vtu:3: VTKFile: header_type is 'UInt16'; expected UInt32 or UInt64");
  CHECK(vtu_error("header_type=", "compressor=\"vtkLZ4DataCompressor\" header_type=") ==
        "m.vtu:3: VTKFile: compressor is 'vtkLZ4DataCompressor'; expected vtkZLibDataCompressor or none");
  CHECK(vtu_error("</PointData>", "</PointDatum>") ==
        "m.vtu:10: </PointDatum> closes <PointData>; expected </PointData>");
  CHECK(vtu_error("NumberOfPoints=\"6\"", "NumberOfPoints=6") ==
        "m.vtu:5: the value of an attribute is not quoted; expected '\"'");
  CHECK(vtu_error("NumberOfPoints=\"6\"", "NumberOfPoints=\"six\"") ==
        "m.vtu:5: Piece: NumberOfPoints is 'six'; expected a whole number, not negative");
  CHECK(vtu_error("NumberOfPoints=\"6\"", "NumberOfPoints=\"1000000000000\"")
            .starts_with("m.vtu:5: Piece: NumberOfPoints is 1000000000000; expected no more than a file of "));
  CHECK(vtu_error("NumberOfPoints=\"6\"", "NumberOfPoints=\"7\"") ==
        "m.vtu:17: DataArray 'Points': holds 18 values; expected 21");
  CHECK(vtu_error("a comment", "a comment &nonsense; <") == "");
  CHECK(vtu_error("Scalars=\"a\"", "Scalars=\"&wrong;\"") ==
        "m.vtu:11: found '&wrong;\"'; expected &lt; &gt; &amp; &quot; or &apos;");
  CHECK(vtu_error("</VTKFile>", "</VTKFile>more") ==
        "m.vtu:34: something follows the last element; expected the end of the file");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  CHECK(error_of("m.vtu", deep) == "m.vtu:1: elements are nested too deeply; expected at most 32 levels");
}

TEST_CASE("VTU: bad arrays", "[mesh_io]") {
  CHECK(vtu_error("9.000000 8.000000", "9.000000 inf") ==
        "m.vtu:18: DataArray 'Points': a coordinate is infinite; expected a finite number");
  CHECK(vtu_error("Name=\"types\"", "Name=\"type\"") == "m.vtu:21: Cells: has no DataArray 'types'; expected one");
  CHECK(vtu_error("1 2 3 4 \n", "1 2 3 6 \n") ==
        "m.vtu:22: DataArray 'connectivity': cell 4 names point 6; expected 0 to 5");
  CHECK(vtu_error("1 3 6 10 14", "1 3 6 10 15") ==
        "m.vtu:22: DataArray 'connectivity': cell 4 ends at offset 15; expected 10 to 14");
  CHECK(vtu_error("type=\"UInt8\"", "type=\"String\"") ==
        "m.vtu:28: DataArray 'types': type is 'String'; expected Int8 to UInt64, Float32 or Float64");
  CHECK(vtu_error("type=\"UInt8\"", "type=\"Float32\"") ==
        "m.vtu:28: DataArray 'types': type is Float32; expected an integer type");
  CHECK(vtu_error("Name=\"Points\" NumberOfComponents=\"3\"", "Name=\"Points\" NumberOfComponents=\"2\"") ==
        "m.vtu:17: DataArray 'Points': NumberOfComponents is '2'; expected 3");

  for (const MeshSample& one : vtu_samples()) {
    INFO(one.format << " " << one.file);
    if (one.format.find("appended") != std::string::npos) {
      CHECK(error_of("m.vtu", replaced(one.content, "offset=\"0\"", "offset=\"0000000000000\"")) == "");
      const std::size_t at = one.content.find("offset=\"", one.content.find("Name=\"Points\"")) + 8;
      std::string far = one.content;
      far.replace(at, far.find('"', at) - at, "99999999");
      CHECK(error_of("m.vtu", far).find("DataArray 'Points': offset is 99999999; expected at most ") !=
            std::string::npos);
    }
    if (one.format == "VTU base64") {
      const std::size_t at = one.content.find("\">\n", one.content.find("Name=\"types\"")) + 5;
      std::string bad = one.content;
      bad[at + 6] = '!';
      CHECK(error_of("m.vtu", bad).find("DataArray 'types': is not ") != std::string::npos);
    }
    if (one.format == "VTU appended raw" || one.format == "VTU appended raw, zlib") {
      // the size, or the number of blocks, of the first array: the mesh has no such array, but the region array is one
      const std::size_t first = one.content.find("\n _") + 3;
      const std::size_t offset = one.content.find("offset=\"", one.content.find("Name=\"gmsh:physical\"")) + 8;
      std::string lies = one.content;
      lies.replace(first + std::stoul(lies.substr(offset)), 4, "\xff\xff\xff\xff");
      const std::string text = error_of("m.vtu", lies);
      INFO(text);
      CHECK(text.find("DataArray 'gmsh:physical': claims ") != std::string::npos);
    }
  }
}

TEST_CASE("VTU: no memory is allocated for a compressed block that claims too much", "[mesh_io]") {
  for (const MeshSample& one : vtu_samples()) {
    if (one.format != "VTU appended raw, zlib" || one.content.find("UInt64\" compressor") == std::string::npos ||
        one.content.find("LittleEndian") == std::string::npos) {
      continue;
    }
    const std::size_t first = one.content.find("\n _") + 3;
    const std::size_t offset = one.content.find("offset=\"", one.content.find("Name=\"Points\"")) + 8;
    const std::size_t block_size = first + std::stoul(one.content.substr(offset)) + 8;
    std::string bomb = one.content;
    bomb.replace(block_size, 8, Bytes().add(std::uint64_t{1} << 50).text);
    const std::string text = error_of("m.vtu", bomb);
    INFO(text);
    CHECK(text.find("DataArray 'Points': block 0 claims ") != std::string::npos);
    CHECK(text.find(" bytes for 1125899906842624; expected no more than the file holds") != std::string::npos);
  }
}
