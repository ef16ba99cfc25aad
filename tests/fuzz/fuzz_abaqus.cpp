// Abaqus .inp; a file that it includes is the input itself.
#include "sim/mesh/io/formats.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(abaqus) {
  Scanner in("fuzz.inp", data);
  MeshFile file;
  read_abaqus(in, file, [&](const std::string&) { return std::string(data); });
  fuzz::check_file(file);
}
