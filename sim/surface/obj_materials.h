// The materials of a Wavefront .obj: names as its lines "usemtl" give them, colors from its libraries. Names are whole
// lines, for modellers write spaces into them.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "sim/surface/surface_mesh.h"

namespace fascia {

class ObjMaterials {
 public:
  /// Gives the content of a library by its name; throws Error where it cannot.
  using Library = std::function<std::string(const std::string&)>;

  /// `names` as after "mtllib": one library, or several with spaces between them. What is missing becomes a note.
  void read_libraries(const std::string& names, const Library& read);
  /// Of a material of this name, libraries read before or later.
  std::size_t number(std::string_view name);
  /// In the order in which they were met. A note for each that no library has, unless a library is missing, too.
  std::vector<SurfaceMaterial> take(std::vector<std::string>& notes);

 private:
  void read(std::string_view content);

  std::vector<SurfaceMaterial> materials_;
  std::vector<char> described_;                             // [materials_] by a library
  std::unordered_map<std::string, std::size_t> number_of_;  // by name
  std::unordered_set<std::string> libraries_;               // asked for
  std::size_t missing_ = 0;                                 // libraries
  std::vector<std::string> notes_;
};

/// 0xAABBGGRR of shares from 0 to 1, AA = ff.
std::uint32_t packed_color(double r, double g, double b);

}  // namespace fascia
