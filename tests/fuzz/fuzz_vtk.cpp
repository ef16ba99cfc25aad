// VTK legacy files, in text and in binary.
#include "sim/mesh/io/formats.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(vtk) {
  Scanner in("fuzz.vtk", data);
  MeshFile file;
  read_vtk_legacy(in, file);
  fuzz::check_file(file);
}
