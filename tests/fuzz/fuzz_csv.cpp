// Vectors at the vertices of a mesh of 100 vertices.
#include "sim/model/vertex_csv.h"
#include "tests/fuzz/fuzz.h"

using namespace fascia;

FUZZ_TARGET(csv) {
  constexpr std::size_t vertex_count = 100;
  const VertexTable table = read_vertex_csv_content("fuzz.csv", data, vertex_count);
  fuzz::require(!table.vertices.empty() && table.vertices.size() == table.values.size(),
                "every row has a vertex and a value");
  for (std::size_t i = 0; i < table.vertices.size(); ++i) {
    fuzz::require(table.vertices[i] < vertex_count, "rows name vertices of the mesh");
    fuzz::require(i == 0 || table.vertices[i - 1] < table.vertices[i], "rows are in order");
    fuzz::require(table.values[i].allFinite(), "values are finite");
  }
}
