#include <zlib.h>

#include "tests/support/meshes/samples.h"

namespace fascia::test {
namespace {

// A vertex, a line, a triangle and the two tets.
const std::string old_text = R"(# vtk DataFile Version 2.0
a title
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 6 double
0 0 0 1 0 0 0 1 0
0 0 1 1 1 1.5 9 8 7
CELLS 5 19
1 4
2 0 1
3 0 1 2
4 0 1 2 3
4 1 2 3 4
CELL_TYPES 5
1
3
5
10
10
CELL_DATA 5
SCALARS quality double 1
LOOKUP_TABLE default
0 1 2 3 4
SCALARS Material int
LOOKUP_TABLE default
1 5 11 3 7
POINT_DATA 6
VECTORS u double
1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9
SCALARS temperature float 1
LOOKUP_TABLE default
1 2 3 4 5 6
)";

const std::string new_text = R"(# vtk DataFile Version 5.1
a title
ASCII
DATASET UNSTRUCTURED_GRID
FIELD FieldData 2
names 1 2 string
hello%20there
again
time 1 1 double
0.5
POINTS 6 float
0 0 0 1 0 0 0 1 0
0 0 1 1 1 1.5 9 8 7
METADATA
INFORMATION 0

CELLS 6 14
OFFSETS vtktypeint64
0 1 3 6 10 14
CONNECTIVITY vtktypeint64
4 0 1 0 1 2 0 1 2 3
1 2 3 4
CELL_TYPES 5
1
3
5
10
10
CELL_DATA 5
FIELD FieldData 2
quality%20of%20it 2 5 float
1 2 3 4 5 6 7 8 9 10
METADATA
COMPONENT_NAMES
a
b

CellEntityIds 1 5 vtktypeint64
1 5 11 3 7
)";

std::vector<double> coordinates() {
  std::vector<double> out;
  for (const Eigen::Vector3d& x : sample_mesh().positions) out.insert(out.end(), {x[0], x[1], x[2]});
  return out;
}

std::string old_binary() {
  Bytes out(true);
  out.add_text("# vtk DataFile Version 3.0\na title\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n");
  out.add_all(coordinates()).add_text("\nCELLS 5 19\n");
  out.add_all<int>({1, 4, 2, 0, 1, 3, 0, 1, 2, 4, 0, 1, 2, 3, 4, 1, 2, 3, 4}).add_text("\nCELL_TYPES 5\n");
  out.add_all<int>({1, 3, 5, 10, 10}).add_text("\nCELL_DATA 5\nSCALARS flags bit 1\nLOOKUP_TABLE default\n");
  out.add<char>(' ').add_text("\nFIELD FieldData 2\nquality 1 5 float\n").add_all<float>({1, 2, 3, 4, 5});
  return out.add_text("\nmedit:ref 1 5 short\n").add_all<short>({1, 5, 11, 3, 7}).add_text("\n").text;
}

std::string new_binary() {
  Bytes out(true);
  out.add_text(
      "# vtk DataFile Version 5.1\na title\nBINARY\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\nnames 1 2 string\n");
  out.add<std::uint8_t>(0xc0 | 5).add_text("hello").add<std::uint16_t>(0x8000 | 70).add_text(std::string(70, 'x'));
  out.add_text("\nPOINTS 6 double\n")
      .add_all(coordinates())
      .add_text("\nMETADATA\nINFORMATION 0\n\nCELLS 6 14\nOFFSETS vtktypeint64\n");
  out.add_all<std::int64_t>({0, 1, 3, 6, 10, 14}).add_text("\nCONNECTIVITY vtktypeint64\n");
  out.add_all<std::int64_t>({4, 0, 1, 0, 1, 2, 0, 1, 2, 3, 1, 2, 3, 4}).add_text("\nCELL_TYPES 5\n");
  out.add_all<int>({1, 3, 5, 10, 10}).add_text("\nCELL_DATA 5\nSCALARS region unsigned_char 1\nLOOKUP_TABLE default\n");
  return out.add_all<std::uint8_t>({1, 5, 11, 3, 7}).add_text("\n").text;
}

std::string base64(const std::string& bytes) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  unsigned buffer = 0;
  int bits = 0;
  for (const char c : bytes) {
    buffer = buffer << 8 | static_cast<unsigned char>(c);
    for (bits += 8; bits >= 6; bits -= 6) out += digits[buffer >> (bits - 6) & 63];
  }
  if (bits > 0) out += digits[buffer << (6 - bits) & 63];
  while (out.size() % 4 != 0) out += '=';
  return out;
}

enum class Place { text, inline_base64, appended_raw, appended_base64 };

struct VtuFlavor {
  Place place;
  bool deflated, big_endian, wide_header;
};

class VtuBuilder {
 public:
  explicit VtuBuilder(const VtuFlavor& flavor) : flavor_(flavor) {}

  template <class T>
  std::string array(const std::string& type, const std::string& name, const std::vector<T>& values,
                    const std::string& more = "") {
    std::string head = "<DataArray type=\"" + type + "\" Name=\"" + name + "\"" + more + " format=\"";
    Bytes bytes(flavor_.big_endian);
    bytes.add_all(values);
    switch (flavor_.place) {
      case Place::text: {
        std::string text;
        for (const T value : values) text += std::to_string(value) + " ";
        return head + "ascii\">\n" + text +
               "\n<InformationKey name=\"L2_NORM_RANGE\">1 2</InformationKey></DataArray>\n";
      }
      case Place::inline_base64:
        return head + "binary\">\n  " + packed(bytes.text, true) + "\n</DataArray>\n";
      default:
        break;
    }
    head += "appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
    appended_ += packed(bytes.text, flavor_.place == Place::appended_base64);
    return head;
  }

  std::string document() {
    std::string out = "<?xml version=\"1.0\"?>\n<!-- a comment -->\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\"";
    out += std::string(" byte_order='") + (flavor_.big_endian ? "Big" : "Little") + "Endian'";
    if (flavor_.wide_header) out += " header_type=\"UInt64\"";
    if (flavor_.deflated) out += " compressor=\"vtkZLibDataCompressor\"";
    out += ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"6\" NumberOfCells=\"5\">\n<PointData>\n";
    out += array<float>("Float32", "temperature", {1, 2, 3, 4, 5, 6}) + "</PointData>\n<CellData Scalars=\"a\">\n";
    out += array<int>("Int32", "gmsh:physical", {1, 5, 11, 3, 7}) + "</CellData>\n<Points>\n";
    const std::vector<double> x = coordinates();
    const std::string three = " NumberOfComponents=\"3\"";
    out += flavor_.wide_header ? array<double>("Float64", "Points", x, three)
                               : array<float>("Float32", "Points", std::vector<float>(x.begin(), x.end()), three);
    out += "</Points>\n<Cells>\n";
    out += array<std::int64_t>("Int64", "connectivity", {4, 0, 1, 0, 1, 2, 0, 1, 2, 3, 1, 2, 3, 4});
    out += array<std::uint32_t>("UInt32", "offsets", {1, 3, 6, 10, 14});
    out += array<std::uint8_t>("UInt8", "types", {1, 3, 5, 10, 10}) + "</Cells>\n</Piece>\n</UnstructuredGrid>\n";
    if (!appended_.empty()) {
      const bool raw = flavor_.place == Place::appended_raw;
      out += std::string("<AppendedData encoding=\"") + (raw ? "raw" : "base64") + "\">\n _" + appended_ +
             "\n</AppendedData>\n";
    }
    return out + "</VTKFile>\n";
  }

 private:
  std::string words(const std::vector<std::uint64_t>& values) const {
    Bytes out(flavor_.big_endian);
    for (const std::uint64_t value : values) {
      flavor_.wide_header ? out.add(value) : out.add(static_cast<std::uint32_t>(value));
    }
    return out.text;
  }

  std::string packed(const std::string& bytes, bool as_base64) const {
    if (!flavor_.deflated) return as_base64 ? base64(words({bytes.size()}) + bytes) : words({bytes.size()}) + bytes;
    constexpr std::size_t block = 32;
    std::vector<std::uint64_t> header = {(bytes.size() + block - 1) / block, block, bytes.size() % block};
    std::string body;
    for (std::size_t at = 0; at < bytes.size(); at += block) {
      const std::string part = bytes.substr(at, block);
      uLongf size = compressBound(part.size());
      std::string deflated(size, '\0');
      compress(reinterpret_cast<Bytef*>(deflated.data()), &size, reinterpret_cast<const Bytef*>(part.data()),
               part.size());
      body += deflated.substr(0, size);
      header.push_back(size);
    }
    return as_base64 ? base64(words(header)) + base64(body) : words(header) + body;
  }

  VtuFlavor flavor_;
  std::string appended_;
};

}  // namespace

std::vector<MeshSample> vtk_samples() {
  return {{"VTK legacy 2.0 ASCII", "old_text.vtk", old_text},
          {"VTK legacy 5.1 ASCII", "new_text.vtk", new_text},
          {"VTK legacy 3.0 binary", "old_binary.vtk", old_binary()},
          {"VTK legacy 5.1 binary", "new_binary.vtk", new_binary()}};
}

std::vector<MeshSample> vtu_samples() {
  std::vector<MeshSample> out;
  const std::vector<std::pair<std::string, Place>> places = {{"VTU base64", Place::inline_base64},
                                                             {"VTU appended raw", Place::appended_raw},
                                                             {"VTU appended base64", Place::appended_base64}};
  out.push_back({"VTU ASCII", "text.vtu", VtuBuilder({Place::text, false, false, true}).document()});
  for (const auto& [format, place] : places) {
    for (const bool deflated : {false, true}) {
      for (const bool big_endian : {false, true}) {
        for (const bool wide_header : {false, true}) {
          const std::string name = "f" + std::to_string(out.size()) + ".vtu";
          out.push_back({format + (deflated ? ", zlib" : ""), name,
                         VtuBuilder({place, deflated, big_endian, wide_header}).document()});
        }
      }
    }
  }
  return out;
}

}  // namespace fascia::test
