#include "sim/mesh/io/foreign_formats.h"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace fascia {
namespace {

using std::string_view;
using namespace std::string_view_literals;

constexpr const char* kGmsh = "Gmsh converts it: gmsh FILE -save -format msh41 -o OUT.msh";
constexpr const char* kGmshFills = "Gmsh fills it with tets: gmsh FILE -3 -o OUT.msh";
constexpr const char* kParaView = "ParaView opens it and saves its mesh as .vtu";
constexpr const char* kBlender = "Blender imports it and exports a surface as .stl, .ply or .obj";
constexpr const char* kSlicer = "3D Slicer imports it as a segmentation and exports a surface as .stl, .ply or .obj";

struct Row {
  ForeignFormat format;
  std::initializer_list<string_view> begins;   // the content begins with one of them
  std::initializer_list<string_view> holds;    // or has one of them in its first lines
  std::initializer_list<string_view> endings;  // or the file has this ending
};

constexpr std::size_t kFirstLines = 4096;  // [bytes]

/// The first row that fits.
const Row* find_row(string_view content, string_view ending) {
  static const Row rows[] = {
      {{"an LS-DYNA keyword file", "FEBio Studio opens it and saves a .feb"}, {"*KEYWORD"sv}, {"\n*KEYWORD"sv}, {}},
      {{"an XDMF mesh", "ParaView, or 'meshio convert FILE OUT.vtu', makes a .vtu of it"}, {}, {"<Xdmf"sv}, {}},
      {{"a COLLADA scene", kBlender}, {}, {"<COLLADA"sv}, {}},
      {{"an X3D scene", kBlender}, {}, {"<X3D"sv}, {}},
      {{"a VRML scene", kBlender}, {"#VRML"sv}, {}, {}},
      {{"a USD scene", kBlender}, {"#usda"sv, "PXR-USDC"sv}, {}, {".usdz"sv}},
      {{"a 3MF model", "a slicer or Blender exports it as .stl"}, {}, {}, {".3mf"sv}},
      {{"a glTF scene", kBlender}, {"glTF"sv}, {}, {".gltf"sv}},
      {{"an FBX scene", kBlender}, {"Kaydara FBX"sv, "; FBX"sv}, {}, {".fbx"sv}},
      {{"a Blender file", "Blender exports its surfaces as .stl, .ply or .obj"}, {"BLENDER"sv}, {}, {".blend"sv}},
      {{"a 3D Studio scene", kBlender}, {}, {}, {".3ds"sv}},
      {{"an NRRD image", kSlicer}, {"NRRD000"sv}, {}, {".nhdr"sv}},
      {{"a NIfTI image", kSlicer}, {}, {}, {".nii"sv, ".nii.gz"sv}},
      {{"a DICOM or MetaImage volume", kSlicer}, {}, {}, {".dcm"sv, ".mha"sv, ".mhd"sv}},
      {{"a STEP model", kGmshFills}, {"ISO-10303-21"sv}, {}, {".step"sv, ".stp"sv}},
      {{"an IGES model", kGmshFills}, {}, {}, {".iges"sv, ".igs"sv}},
      {{"a BREP model", kGmshFills}, {"DBRep_DrawableShape"sv, "CASCADE Topology"sv}, {}, {".brep"sv}},
      {{"a Gmsh geometry", kGmshFills}, {}, {}, {".geo"sv}},
      {{"a MED mesh", kGmsh}, {}, {}, {".med"sv}},
      {{"an Exodus II mesh", kParaView}, {"CDF\1"sv, "CDF\2"sv, "CDF\5"sv}, {}, {".exo"sv, ".ex2"sv, ".e"sv}},
      {{"an HDF5 file", kParaView}, {"\x89HDF"sv}, {}, {}},
      {{"a Nastran deck", kGmsh}, {}, {"BEGIN BULK"sv, "\nGRID"sv, "\nCTETRA"sv}, {".bdf"sv, ".nas"sv}},
      {{"a universal file (I-DEAS)", kGmsh}, {}, {}, {".unv"sv}},
      {{"a binary Medit mesh", kGmsh}, {"\1\0\0\0"sv, "\0\0\0\1"sv}, {}, {".meshb"sv}},
      {{"a gzip archive", "gunzip unpacks it"}, {"\x1f\x8b"sv}, {}, {}},
      {{"a ZIP archive", "unzip unpacks it"}, {"PK\3\4"sv}, {}, {}},
      {{"an Ansys archive", "FEBio Studio opens it and saves a .feb"}, {"/COM"sv, "/PREP7"sv}, {}, {".cdb"sv}},
  };
  const auto any = [](std::initializer_list<string_view> texts, auto fits) {
    return std::any_of(texts.begin(), texts.end(), fits);
  };
  const string_view lines = content.substr(0, kFirstLines);
  for (const Row& row : rows) {
    if (any(row.begins, [&](string_view b) { return content.starts_with(b); }) ||
        any(row.holds, [&](string_view h) { return lines.find(h) != lines.npos; }) ||
        any(row.endings, [&](string_view e) { return e == ending; }))
      return &row;
  }
  return nullptr;
}

}  // namespace

std::optional<ForeignFormat> foreign_format(string_view content, const std::string& ending) {
  constexpr std::size_t nifti_magic = 344;  // NIfTI-1 names itself behind its header
  const bool nifti = content.size() > nifti_magic && (content.substr(nifti_magic).starts_with("n+1\0"sv) ||
                                                      content.substr(nifti_magic).starts_with("ni1\0"sv));
  const Row* const row = find_row(content, nifti ? ".nii" : string_view(ending));
  if (!row) return std::nullopt;
  return row->format;
}

std::string way_of_vtk_dataset(string_view kind) {
  constexpr std::array images = {"STRUCTURED_POINTS"sv, "ImageData"sv, "PImageData"sv};
  constexpr std::array others = {"STRUCTURED_GRID"sv,      "RECTILINEAR_GRID"sv, "StructuredGrid"sv,
                                 "RectilinearGrid"sv,      "PPolyData"sv,        "PUnstructuredGrid"sv,
                                 "vtkMultiBlockDataSet"sv, "Collection"sv};
  const auto is_kind = [&](string_view known) { return kind == known; };
  if (std::any_of(images.begin(), images.end(), is_kind)) return std::string("; ") + kSlicer;
  if (std::any_of(others.begin(), others.end(), is_kind)) return std::string("; ") + kParaView;
  return "";
}

}  // namespace fascia
