// OFF in text.
#include "sim/mesh/io/formats.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(off) {
  Scanner in("fuzz.off", data);
  MeshFile file;
  read_off(in, file);
  fuzz::check_file(file);
}
