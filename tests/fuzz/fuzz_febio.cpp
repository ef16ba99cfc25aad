// FEBio .feb.
#include "sim/mesh/io/formats.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(febio) {
  Scanner in("fuzz.feb", data);
  MeshFile file;
  read_febio(in, file);
  fuzz::check_file(file);
}
