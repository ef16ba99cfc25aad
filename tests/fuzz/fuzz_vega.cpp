// Vega .veg; a file that it includes is the input itself.
#include "sim/mesh/io/formats.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(vega) {
  Scanner in("fuzz.veg", data);
  MeshFile file;
  read_vega(in, file, [&](const std::string&) { return std::string(data); });
  fuzz::check_file(file);
}
