#include "sim/mesh/pieces.h"

#include <catch2/catch.hpp>

using namespace fascia;

TEST_CASE("pieces are numbered by their lowest vertices, and vertices of no tet are pieces") {
  const std::vector<Tet> tets = {{9, 7, 8, 6}, {1, 2, 4, 5}, {5, 11, 12, 13}};
  CHECK(pieces_of(tets, 14) == std::vector<std::uint32_t>{0, 1, 1, 2, 1, 1, 3, 3, 3, 3, 4, 1, 1, 1});
  CHECK(pieces_of({}, 3) == std::vector<std::uint32_t>{0, 1, 2});
}
