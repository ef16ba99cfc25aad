// PLY, in text and in binary.
#include "sim/mesh/io/formats.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(ply) {
  Scanner in("fuzz.ply", data);
  MeshFile file;
  read_ply(in, file);
  fuzz::check_file(file);
}
