// The zlib format: data compressed by another program, and incomplete data.
#include "base/deflate.h"

#include <catch2/catch.hpp>
#include <random>

using namespace fascia;

TEST_CASE("deflated data are restored, and text gets smaller") {
  std::mt19937 random(2);
  std::string noise(100000, '\0'), digits;
  for (char& c : noise) c = static_cast<char>(random());
  for (int i = 0; i < 20000; ++i) digits += std::to_string(random() % 100) + " ";
  for (const std::string& bytes : {std::string(), std::string("abc"), std::string(5, '\0'), noise, digits}) {
    const std::string made = deflated(bytes);
    CAPTURE(bytes.size(), made.size());
    CHECK(can_inflate_to(bytes.size(), made.size()));
    const auto back = inflated(made, bytes.size());
    REQUIRE(back);
    CHECK((*back == bytes));
  }
  CHECK(deflated(digits).size() < digits.size() / 2);
}

TEST_CASE("a stream of another program is read") {
  // zlib.compress(b"abc") of Python 3.
  const std::string stream("\x78\x9c\x4b\x4c\x4a\x06\x00\x02\x4d\x01\x27", 11);
  CHECK(inflated(stream, 3) == "abc");
}

TEST_CASE("truncated, extended, corrupted or wrongly sized data are refused") {
  const std::string bytes = "soft tissue, soft tissue, soft tissue", made = deflated(bytes);
  REQUIRE(inflated(made, bytes.size()) == bytes);
  CHECK_FALSE(inflated(made, bytes.size() - 1));
  CHECK_FALSE(inflated(made, bytes.size() + 1));
  CHECK_FALSE(inflated(made + "x", bytes.size()));
  for (std::size_t size = 0; size < made.size(); ++size) {
    CAPTURE(size);
    CHECK_FALSE(inflated(made.substr(0, size), bytes.size()));
  }
  std::string spoiled = made;
  spoiled.back() = static_cast<char>(spoiled.back() ^ 1);  // in the checksum
  CHECK_FALSE(inflated(spoiled, bytes.size()));
  CHECK_FALSE(inflated("", 0));
}

TEST_CASE("a size that deflate cannot reach is refused before memory is allocated") {
  CHECK(can_inflate_to(0, 0));
  CHECK(can_inflate_to(1031, 1));
  CHECK_FALSE(can_inflate_to(1032 * 12, 11));
  CHECK_FALSE(inflated(deflated("abc"), std::uint64_t{1} << 40));
  const std::string zeros(10'000'000, '\0');  // the highest compression of deflate
  CHECK(can_inflate_to(zeros.size(), deflated(zeros).size()));
}
