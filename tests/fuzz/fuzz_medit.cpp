// Medit .mesh in text.
#include "sim/mesh/io/formats.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(medit) {
  Scanner in("fuzz.mesh", data);
  MeshFile file;
  read_medit(in, file);
  fuzz::check_file(file);
}
