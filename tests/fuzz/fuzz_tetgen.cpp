// TetGen's pair of files: the .node file, a line "=====", the .ele file.
#include <algorithm>

#include "sim/mesh/io/formats.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(tetgen) {
  constexpr std::string_view separator = "=====\n";
  const std::size_t end = std::min(data.find(separator), data.size());
  MeshFile file;
  read_tetgen_content("fuzz.node", data.substr(0, end), "fuzz.ele",
                      data.substr(std::min(end + separator.size(), data.size())), file);
  fuzz::check_file(file);
}
