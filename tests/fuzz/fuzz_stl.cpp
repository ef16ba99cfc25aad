// STL, in text and in binary.
#include "sim/mesh/io/formats.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(stl) { fuzz::check_file(read_mesh_content("fuzz.stl", data)); }
