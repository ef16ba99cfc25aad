// Grabs on the command line: the JSON document of a text.
#include "sim/scene/grab_text.h"

#include <catch2/catch.hpp>

#include "base/error.h"

using namespace fascia;
using nlohmann::json;

TEST_CASE("keys and values of a grab's text are those of its element in a scene file") {
  CHECK(grab_document("at=0.1,0.05,0;translate=0,0.1,0;start=0.2;duration=0.5;release=1.5;radius=0.02") ==
        json::parse(R"({"at": [0.1, 0.05, 0], "translate": [0, 0.1, 0], "start": 0.2, "duration": 0.5, "release": 1.5,
                        "radius": 0.02})"));
  CHECK(grab_document("smooth=true;push=-1e-3;note=hello") ==
        json::parse(R"({"smooth": true, "push": -0.001, "note": "hello"})"));
  CHECK(grab_document("") == json::object());
  CHECK(grab_document(" ; at=1,2,3;; start=1; ") == json::parse(R"({"at": [1, 2, 3], "start": 1})"));
}

TEST_CASE("a path has a key between slashes, of one number, too") {
  CHECK(grab_document("path=0,0,0,0/0.5,0,0.1,0") == json::parse(R"({"path": [[0, 0, 0, 0], [0.5, 0, 0.1, 0]]})"));
  CHECK(grab_document("path=1") == json::parse(R"({"path": [[1]]})"));
}

TEST_CASE("text that begins like JSON is JSON, and a body's name stays a text") {
  CHECK(grab_document(R"(select={"group":"tip"})") == json::parse(R"({"select": {"group": "tip"}})"));
  CHECK(grab_document("path=[[1,2,3,4]]") == json::parse(R"({"path": [[1, 2, 3, 4]]})"));
  CHECK(grab_document("body=2") == json::parse(R"({"body": "2"})"));
  CHECK(grab_document("body={a},b") == json::parse(R"({"body": "{a},b"})"));
}

TEST_CASE("words within a list are texts, for the reader of scenes to refuse") {
  CHECK(grab_document("at=0.1,x,") == json::parse(R"({"at": [0.1, "x", ""]})"));
  CHECK(grab_document("start=") == json::parse(R"({"start": ""})"));
  CHECK(grab_document("start=1 2") == json::parse(R"({"start": "1 2"})"));
}

TEST_CASE("parts that are no KEY=VALUE, keys given twice and broken JSON are errors") {
  CHECK_THROWS_WITH(grab_document("at=1,2,3;oops"),
                    "--grab: oops is not KEY=VALUE; expected such as at=0.1,0.05,0;translate=0,0.1,0");
  CHECK_THROWS_WITH(grab_document("=3"), Catch::StartsWith("--grab: =3 is not KEY=VALUE"));
  CHECK_THROWS_WITH(grab_document("at=1;at=2"), "--grab: at is given twice; expected each key once");
  CHECK_THROWS_WITH(grab_document("select={\"group\""), Catch::StartsWith("--grab select:1:"));
}
