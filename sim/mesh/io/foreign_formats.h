// Formats that fascia does not read, and the way to bring their meshes in.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace fascia {

struct ForeignFormat {
  const char* name;  // "an Exodus II mesh (netCDF)"
  const char* way;   // "ParaView saves its mesh as .vtu"
};

/// By the first bytes, or by the ending (lower case, with the dot) where those do not tell.
std::optional<ForeignFormat> foreign_format(std::string_view content, const std::string& ending);

/// The end of an error about a kind of VTK dataset, as legacy or XML files name it, that fascia does not read: "; " and
/// the way, or nothing.
std::string way_of_vtk_dataset(std::string_view kind);

}  // namespace fascia
