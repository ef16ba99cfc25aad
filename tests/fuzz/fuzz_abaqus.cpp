// Abaqus .inp.
#include "sim/mesh/io/formats.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(abaqus) {
  Scanner in("fuzz.inp", data);
  MeshFile file;
  read_abaqus(in, file);
  fuzz::check_file(file);
}
