// Grabs on the command line: the JSON document of a text.
#include "sim/scene/grab_text.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using nlohmann::json;

TEST_CASE("keys and values of a grab's text are those of its element in a scene file") {
  CHECK(grab_document("at=0.1,0.05,0;translate=0,0.1,0;start=0.2;duration=0.5;release=1.5;radius=0.02") ==
        json::parse(R"({"at": [0.1, 0.05, 0], "translate": [0, 0.1, 0], "start": 0.2, "duration": 0.5, "release": 1.5,
                        "radius": 0.02})"));
  CHECK(grab_document("smooth=true;push=-1e-3;note=hello") ==
        json::parse(R"({"smooth": true, "push": -0.001, "note": "hello"})"));
  CHECK(grab_document("at=.1,+5,5.;radius=-.5e-3") == json::parse(R"({"at": [0.1, 5, 5], "radius": -0.5e-3})"));
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

TEST_CASE("what would do nothing is an error of a grab's text") {
  CHECK_THROWS_WITH(grab_document("at=1,2,3;body="), "--grab: body: is \"\"; expected the name of a body");
  CHECK_THROWS_WITH(grab_document("at=1,2,3;duration=1"),
                    "--grab: duration: has no motion; expected it beside translate or push");
  CHECK_THROWS_WITH(grab_document("at=1,2,3;smooth=true"),
                    "--grab: smooth: has no motion; expected it beside translate or push");
}

TEST_CASE("wrong values of a grab's text are errors that name the key") {
  const auto error = [](const std::string& text) {
    return test::SceneFile(test::scene_text()).open_error({"--grab " + text});
  };
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"radius=1", "--grab: holds nothing; expected at"},
      {"at=1,2", "--grab: grabs[0].at: is [1,2]; expected a list of 3 numbers [m]"},
      {"at=nan,0,0", "--grab: grabs[0].at[0]: is \"nan\"; expected a number"},
      {"at=1,2,3;radius=-1", "--grab: grabs[0].radius: is -1; expected 1e-09 to 1e+06 m"},
      {"at=1,2,3;stiffness=inf", "--grab: grabs[0].stiffness: is \"inf\"; expected a number"},
      {"at=1,2,3;start=-1", "--grab: grabs[0].start: is -1; expected 0 to 1e+09 s"},
      {"at=1,2,3;push=1;duration=-1", "--grab: grabs[0].duration: is -1; expected 0 to 1e+09 s"},
      {"at=1,2,3;start=1;release=0.5", "--grab: grabs[0].release: is 0.5; expected a time after start"},
      {"at=1,2,3;push=1;translate=0,1,0", "--grab: has more than one of translate, push and path"},
      {"at=1,2,3;push=1;smooth=yes", "--grab: grabs[0].smooth: is \"yes\"; expected true or false"},
      {"at=1,2,3;path=0,0,0,0/1,0,0,x", "--grab: grabs[0].path[1][3]: is \"x\"; expected a number"},
      {"at=1,2,3;path=0,0,0,0/0,1,0,0", "--grab: grabs[0].path[1]: is [0,1,0,0]; expected a later time"},
      {"at=1,2,3;trnslate=0,1,0", "--grab: grabs[0].trnslate: unknown key \"trnslate\", perhaps \"translate\""},
  };
  for (const auto& [text, begin] : cases) {
    CAPTURE(text);
    CHECK_THAT(error(text), Catch::StartsWith(begin));
  }
}
