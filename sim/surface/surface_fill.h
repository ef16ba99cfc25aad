// A closed surface as a tet mesh: read, checked, repaired and filled by a lattice (sim/surface/isosurface_stuffing.h).
#pragma once
#include <filesystem>
#include <optional>

#include "sim/mesh/io/mesh_io.h"
#include "sim/surface/isosurface_stuffing.h"
#include "sim/surface/surface_repair.h"

namespace fascia {

inline constexpr int kFewestCells = 2, kMostCells = 256;  // limits of a resolution, along the longest side

struct FilledSurface {
  SurfaceMesh surface;  // of the file, repaired
  SurfaceRepair repaired;
  MeshFile file;  // the tets, with notes about the surface, then about the filling
  std::ptrdiff_t notes_of_surface = 0;
  int resolution = 0;  // cells along the longest side
};

/// Tets for a surface. The default resolution gives about 7,000 of them, or more if the surface is too thin for that.
/// Throws Error with `where` for a surface without an inside and for a resolution that gives more than some millions of
/// tets.
FilledSurface fill_surface(SurfaceMesh surface, const std::string& where, std::optional<int> resolution,
                           const Progress& progress = {});

/// The mesh of a file, or the filled surface of one.
MeshFile read_mesh_or_fill(const std::filesystem::path& path, std::optional<int> resolution = {},
                           const Progress& progress = {});

}  // namespace fascia
