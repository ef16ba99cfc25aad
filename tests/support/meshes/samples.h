// The same small mesh in every format and variant, for the tests of the readers. Generated here, byte by byte, so that
// the readers are not tested against fascia's own writers.
#pragma once
#include <string>
#include <vector>

#include "sim/mesh/io/mesh_io.h"
#include "tests/support/support.h"

namespace fascia::test {

/// Six vertices, the last unreferenced, and two tets: (0,1,2,3) of region 3, (1,2,3,4) of region 7.
TetMesh sample_mesh();

/// The data of the sample that a format stores besides the tets.
enum class Keeps {
  tets,     // no regions
  regions,  // region numbers
  numbers,  // as groups named by number: 3, 7, 11, 5, 9
  groups,   // names: region 3 "left part", 7 "right"; surface "clamp" {0,1,2}, curve 5 {0,1}, point "tip" {4}
};

struct MeshSample {
  std::string format;   // expected MeshFile::format
  std::string file;     // name of the file to write
  std::string content;  // of that file
  Keeps keeps = Keeps::regions;
  std::string node_content = {};  // of the .node file, for TetGen
};
std::vector<MeshSample> gmsh_samples();
std::vector<MeshSample> vtk_samples();
std::vector<MeshSample> vtu_samples();
std::vector<MeshSample> other_samples();
std::vector<MeshSample> all_samples();
/// The content of the sample of this name, which must be one of them.
std::string sample_content(const std::string& file);

/// Writes a sample into a folder and returns the path to open.
std::filesystem::path write_sample(const TemporaryFolder& folder, const MeshSample& sample);

/// Replaces text, which must occur.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// The error of read_mesh for a file with this content, without the folder: "mesh.msh:3: ...". "" if it is read.
std::string error_of(const std::string& file, const std::string& content, const std::string& node_content = {});

/// Checks positions, tets, regions and, as far as the sample's format stores them, names and groups.
void check_sample(const MeshFile& file, const MeshSample& sample);

/// A string of binary numbers in a byte order.
class Bytes {
 public:
  explicit Bytes(bool big_endian = false) : big_endian_(big_endian) {}
  template <class T>
  Bytes& add(T value) {
    std::string raw(reinterpret_cast<const char*>(&value), sizeof value);
    text += big_endian_ ? std::string(raw.rbegin(), raw.rend()) : raw;  // the tests run on little-endian machines
    return *this;
  }
  template <class T>
  Bytes& add_all(const std::vector<T>& values) {
    for (const T& value : values) add(value);
    return *this;
  }
  Bytes& add_text(const std::string& more) {
    text += more;
    return *this;
  }
  std::string text;

 private:
  bool big_endian_;
};

}  // namespace fascia::test
