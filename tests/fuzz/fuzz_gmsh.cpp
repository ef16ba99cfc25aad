// Gmsh .msh 1.0, 2.x and 4.1, in text and in binary.
#include "sim/mesh/io/formats.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(gmsh) {
  Scanner in("fuzz.msh", data);
  MeshFile file;
  read_gmsh(in, file);
  fuzz::check_file(file);
}
