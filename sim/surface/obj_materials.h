// The materials of a Wavefront .obj: names from its "usemtl" lines, colors from its libraries. Names are whole lines,
// since modeling programs write spaces into them.
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
  /// Returns the content of a library by its name; throws Error on failure.
  using Library = std::function<std::string(const std::string&)>;

  /// `names` as after "mtllib": one library, or several separated by spaces. A missing library becomes a note.
  void read_libraries(const std::string& names, const Library& read);
  /// The number of a material with this name, whether its library is read before or later.
  std::size_t number(std::string_view name);
  /// In order of first use. Adds a note for each that no library defines, unless a library is missing, too.
  std::vector<SurfaceMaterial> take(std::vector<std::string>& notes);

 private:
  void read(std::string_view content);

  std::vector<SurfaceMaterial> materials_;
  std::vector<char> described_;                             // [materials_] defined by a library
  std::unordered_map<std::string, std::size_t> number_of_;  // by name
  std::unordered_set<std::string> libraries_;               // requested
  std::size_t missing_ = 0;                                 // number of libraries
  std::vector<std::string> notes_;
};

/// 0xAABBGGRR from shares between 0 and 1, AA = ff.
std::uint32_t packed_color(double r, double g, double b);

}  // namespace fascia
