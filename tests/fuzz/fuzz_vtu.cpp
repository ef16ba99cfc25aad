// VTK XML files, .vtu and .vtp: XML, base64, appended data, zlib.
#include "sim/mesh/io/formats.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(vtu) {
  Scanner in("fuzz.vtu", data);
  MeshFile file;
  read_vtu(in, file);
  fuzz::check_file(file);
}
