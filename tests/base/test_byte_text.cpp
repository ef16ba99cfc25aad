// Base64 against the test vectors of RFC 4648, and the variant of VTK: several streams in one text.
#include "base/byte_text.h"

#include <catch2/catch.hpp>
#include <random>

using namespace fascia;

TEST_CASE("base64 is that of RFC 4648, section 10") {
  for (const auto& [bytes, text] : {std::pair{"", ""},
                                    {"f", "Zg=="},
                                    {"fo", "Zm8="},
                                    {"foo", "Zm9v"},
                                    {"foob", "Zm9vYg=="},
                                    {"fooba", "Zm9vYmE="},
                                    {"foobar", "Zm9vYmFy"}}) {
    CAPTURE(bytes, text);
    CHECK(base64_encoded(bytes) == text);
    const auto decoded = base64_decoded(text);
    REQUIRE(decoded);
    CHECK(decoded->bytes == bytes);
    CHECK(decoded->used == std::string_view(text).size());
  }
  CHECK(base64_encoded("\xfb\xff\xbf") == "+/+/");  // the last two characters of the alphabet
}

TEST_CASE("bytes of every value and number come back") {
  std::mt19937 random(1);
  for (std::size_t size = 0; size < 300; ++size) {
    std::string bytes(size, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    const std::string text = base64_encoded(bytes);
    CAPTURE(size, text);
    CHECK(text.size() == (size + 2) / 3 * 4);
    const auto decoded = base64_decoded(text);
    REQUIRE(decoded);
    CHECK(decoded->bytes == bytes);
  }
}

TEST_CASE("streams one after the other are one, with blanks anywhere") {
  const auto decoded = base64_decoded("Z m\n9\tv Yg==\r\n Zm8= ");
  REQUIRE(decoded);
  CHECK(decoded->bytes == "foobfo");
  CHECK(decoded->used == 19);  // without the blank at the end
}

TEST_CASE("decoding ends with the group that completes the requested size") {
  const std::string text = "Zm9vYmFy?";  // decoding ends before the invalid character
  const auto decoded = base64_decoded(text, 4);
  REQUIRE(decoded);
  CHECK(decoded->bytes == "foobar");
  CHECK(decoded->used == 8);
  CHECK(base64_decoded(text, 3)->bytes == "foo");
  CHECK(base64_decoded(text, 3)->used == 4);
  CHECK(base64_decoded(text, 0)->bytes.empty());
  CHECK_FALSE(base64_decoded(text, 7));
}

TEST_CASE("text that is not base64 is refused") {
  for (const char* text : {"Z", "Zm", "Zm9", "Zm9v?", "Z===", "====", "Zg=a", "Zg=", "Zm9v-_==", "Zm9v\x80mFy"}) {
    CAPTURE(text);
    CHECK_FALSE(base64_decoded(text));
  }
}
