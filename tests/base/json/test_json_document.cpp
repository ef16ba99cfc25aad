// JSON text: the accepted documents, and the place of each error.
#include "base/json/json_document.h"

#include <catch2/catch.hpp>

#include "base/error.h"

using namespace fascia;
using nlohmann::json;

namespace {

std::string error_of(std::string_view text) {
  try {
    parse_json(text, "f.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a document has the values of its text") {
  const json document =
      parse_json(R"( {"a": [1, -2, 2.5, [true, null], {}], "b": {"c": "x\u00e9\n"}, "": 18446744073709551615} )", "f");
  REQUIRE(document.is_object());
  CHECK(document.size() == 3);
  CHECK(document["a"] == json::array({1, -2, 2.5, json::array({true, nullptr}), json::object()}));
  CHECK(document["b"]["c"] == "x\xc3\xa9\n");
  CHECK(document[""] == 18446744073709551615u);
  CHECK(parse_json("3", "f") == 3);
  const json numbers = parse_json("[0.1, 1e-308, 123456789.123456789]", "f");
  CHECK(numbers[0].get<double>() == 0.1);
  CHECK(numbers[1].get<double>() == 1e-308);
  CHECK(numbers[2].get<double>() == 123456789.123456789);
}

TEST_CASE("a syntax error has the line and the column of the byte that is wrong") {
  CHECK_THAT(error_of("{\"a\": 1,\n \"b\": x}"), Catch::StartsWith("f.json:2:7: "));
  CHECK_THAT(error_of("x"), Catch::StartsWith("f.json:1:1: "));
  CHECK_THAT(error_of("{}\n\n}"), Catch::StartsWith("f.json:3:1: "));
  CHECK_THAT(error_of(""), Catch::StartsWith("f.json:1:1: "));
  for (const char* text : {"", "{", "[1,]", "{\"a\" 1}", "nul", "\"\x01\"", "{} {}", "01", "[1e999]"}) {
    const std::string error = error_of(text);
    CAPTURE(text, error);
    CHECK(!error.empty());
    CHECK(error.find('\n') == std::string::npos);
    CHECK(error.find("[json.exception") == std::string::npos);
  }
  CHECK(error_of("\"" + std::string(10000, 'x')).size() < 300);
}

TEST_CASE("numbers that are not finite are no part of JSON") {
  CHECK(error_of("{\"a\": 1,\n \"b\": NaN}") ==
        "f.json:2:7: is NaN, which JSON does not have; expected a finite number");
  for (const std::string word : {"NaN", "nan", "Infinity", "-Infinity", "inf", "-inf", "+INF"})
    CHECK(error_of("[0, " + word + "]") ==
          "f.json:1:5: is " + word + ", which JSON does not have; expected a finite number");
  for (const char* text : {"[infinite]", "[naan]", "[-]", "[x-inf]", "\"NaN", "\"a nan"})
    CHECK_THAT(error_of(text), !Catch::Contains("finite number"));
  CHECK(error_of("\"NaN\"").empty());
}

TEST_CASE("a number that is too large for a double is named with its place") {
  CHECK(error_of("{\"a\": 1,\n \"b\": 1e400}") ==
        "f.json:2:7: is 1e400, which no double holds; expected at most 1.8e308");
  CHECK(error_of("[0, -1.5e+999 , 2]") == "f.json:1:5: is -1.5e+999, which no double holds; expected at most 1.8e308");
  CHECK_THAT(error_of("1e309"), Catch::StartsWith("f.json:1:1: is 1e309, "));
  CHECK(error_of("1" + std::string(10000, '0')).size() < 300);
}

TEST_CASE("a source with control characters is named on one line") {
  CHECK_THROWS_WITH(parse_json("[", "--grab a\x1b"), Catch::StartsWith("\"--grab a\\u001b\":1:2: "));
}

TEST_CASE("a key that is given twice is named with its path") {
  CHECK(error_of(R"({"a": 1, "a": 2})") == "f.json: a: is given twice; expected each key once");
  CHECK(error_of(R"({"a": [0, {"b": {"c": 1, "c": 1}}]})") ==
        "f.json: a[1].b.c: is given twice; expected each key once");
  CHECK(error_of(R"([{"a": 1}, {"a": 1}])").empty());  // in different objects
}

TEST_CASE("nesting ends at a depth") {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  CHECK(error_of(nested(kDeepestNesting)).empty());
  CHECK(error_of(nested(kDeepestNesting + 1)) == "f.json: is nested deeper than 32 levels; expected a scene");
  std::string objects;
  for (std::size_t i = 0; i <= kDeepestNesting; ++i) objects += "{\"a\":";
  CHECK_THAT(error_of(objects), Catch::Contains("nested deeper"));
}

TEST_CASE("paths and values as errors print them") {
  CHECK(path_of_key("", "bodies") == "bodies");
  CHECK(path_of_key("bodies[0]", "mesh") == "bodies[0].mesh");
  CHECK(path_of_key("a", "b\nc") == "a.\"b\\nc\"");
  CHECK(path_of_element("bodies", 12) == "bodies[12]");
  CHECK(on_one_line("plain text") == "plain text");
  CHECK(on_one_line("a\tb") == "\"a\\tb\"");
  CHECK(excerpt(json{{"a", 1}}) == "{\"a\":1}");
  CHECK(excerpt("\xff\n") == "\"\xef\xbf\xbd\\n\"");
  CHECK(excerpt(std::string(58, 'x')) == "\"" + std::string(58, 'x') + "\"");
  CHECK(excerpt(std::string(59, 'x')) == "\"" + std::string(59, 'x') + "...");
}
