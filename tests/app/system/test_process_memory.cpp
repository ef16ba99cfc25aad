// The resident memory of the process.
#include "app/system/process_memory.h"

#include <catch2/catch.hpp>
#include <string>

using namespace fascia;

TEST_CASE("memory that is written to is resident, and counted in bytes") {
  const std::size_t before = resident_bytes();
  REQUIRE(before > 0);
  constexpr std::size_t kMore = 64 << 20;
  std::string block(kMore, 'x');
  const std::size_t with = resident_bytes();
  CAPTURE(before, with, block.back());
  CHECK(with > before + kMore / 2);
  CHECK(with < before + 4 * kMore);
}
