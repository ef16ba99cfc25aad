// Values of a document with their paths: the values, and the message of each error.
#include "base/json/json_node.h"

#include <catch2/catch.hpp>

#include "base/error.h"

using namespace fascia;
using nlohmann::json;

namespace {

const DocumentOrigin kFile{"f.json", {}};

template <class Read>
std::string error_of(const json& value, Read&& read) {
  try {
    read(Node(value, "a.b", kFile));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("numbers are taken within their closed range") {
  const auto number = [](const Node& node) { node.number(-1, 2.5, "m"); };
  for (const json& good : {json(-1), json(2.5), json(0), json(1e-300)}) {
    CAPTURE(good);
    CHECK(error_of(good, number).empty());
  }
  CHECK(Node(json(2.5), "", kFile).number(-1, 2.5, "") == 2.5);
  CHECK(error_of(2.6, number) == "f.json: a.b: is 2.6; expected -1 to 2.5 m");
  CHECK(error_of("1", number) == "f.json: a.b: is \"1\"; expected a number, -1 to 2.5 m");
  CHECK(error_of(json(), number) == "f.json: a.b: is null; expected a number, -1 to 2.5 m");
  CHECK(range_text(1, 1, "Pa") == "1 Pa");
  CHECK(range_text(1e-3, 1e14, "") == "0.001 to 1e+14");
}

TEST_CASE("integers are whole, however they are written") {
  const auto integer = [](const Node& node) { node.integer(1, 10); };
  CHECK(Node(json(10), "", kFile).integer(1, 10) == 10);
  CHECK(Node(json(1e1), "", kFile).integer(1, 10) == 10);
  for (const json& bad : {json(0), json(11), json(1.5), json("1"), json(true), json(1e300)}) {
    CAPTURE(bad);
    CHECK_THAT(error_of(bad, integer), Catch::EndsWith("; expected a whole number, 1 to 10"));
  }
}

TEST_CASE("texts, truth values and vectors") {
  CHECK(Node(json("x"), "", kFile).text("a name") == "x");
  CHECK(error_of(1, [](const Node& n) { n.text("a name"); }) == "f.json: a.b: is 1; expected a name");
  CHECK(Node(json(true), "", kFile).boolean());
  CHECK_FALSE(Node(json(false), "", kFile).boolean());
  CHECK(error_of("True", [](const Node& n) { n.boolean(); }) ==
        "f.json: a.b: is \"True\", perhaps true; expected true or false");
  CHECK(error_of(1, [](const Node& n) { n.boolean(); }) == "f.json: a.b: is 1; expected true or false");
  const auto vector = [](const Node& n) { n.vector(0, 5, "m"); };
  CHECK(Node(json{1, 2.5, 3}, "", kFile).vector(0, 5, "m") == Eigen::Vector3d(1, 2.5, 3));
  CHECK(error_of(json{1, 2}, vector) == "f.json: a.b: is [1,2]; expected a list of 3 numbers [m]");
  CHECK(error_of(json{1, 6, 3}, vector) == "f.json: a.b[1]: is 6; expected 0 to 5 m");
}

TEST_CASE("an object has only the expected keys, and the error of an unknown key names the nearest one") {
  const auto object = [](const Node& n) { n.expect_object({"mesh", "fixed"}); };
  CHECK(error_of(json{{"mesh", 1}}, object).empty());
  CHECK(error_of(json{{"meshes", 1}}, object) ==
        "f.json: a.b.meshes: unknown key \"meshes\", perhaps \"mesh\"; expected one of mesh, fixed");
  CHECK(error_of(json::array(), object) == "f.json: a.b: is []; expected an object with mesh, fixed");
}

TEST_CASE("members and elements have their paths") {
  const json document{{"list", {1, 2}}, {"object", {{"x", 3}}}};
  const Node root(document, "", kFile);
  CHECK(root.is_object());
  CHECK_FALSE(root.find("none"));
  const auto list = root.at("list", "a list").elements("a list");
  REQUIRE(list.size() == 2);
  CHECK_THROWS_WITH(list[1].number(5, 6, ""), "f.json: list[1]: is 2; expected 5 to 6");
  const auto members = root.at("object", "").members("an object");
  REQUIRE(members.size() == 1);
  CHECK(members[0].first == "x");
  CHECK_THROWS_WITH(members[0].second.text("a text"), "f.json: object.x: is 3; expected a text");
  CHECK_THROWS_WITH(root.at("none", "a mesh"), "f.json: none: is missing; expected a mesh");
  CHECK_THROWS_WITH(root.elements("a list"), Catch::EndsWith("; expected a list"));
  CHECK_THROWS_WITH(list[0].members("an object"), "f.json: list[0]: is 1; expected an object");
  CHECK(root.where("none") == "f.json: none");
}

TEST_CASE("a key that is missing leaves its default") {
  const json document{{"n", 3}, {"d", 0.5}, {"v", {1, 2, 3}}};
  const Node root(document, "", kFile);
  int n = 1, other = 7;
  double d = 1, kept = 8;
  Eigen::Vector3d v(0, 0, 0), same(4, 5, 6);
  root.read("n", n, 0, 10);
  root.read("m", other, 0, 10);
  root.read("d", d, 0, 1, "");
  root.read("e", kept, 0, 1, "");
  root.read("v", v, 0, 5, "");
  root.read("w", same, 0, 5, "");
  CHECK(n == 3);
  CHECK(other == 7);
  CHECK(d == 0.5);
  CHECK(kept == 8);
  CHECK(v == Eigen::Vector3d(1, 2, 3));
  CHECK(same == Eigen::Vector3d(4, 5, 6));
}

TEST_CASE("an error in an overridden value names the override, the last one that set it") {
  const DocumentOrigin origin{"f.json",
                              {{"gravity", "gravity", "gravity"},
                               {"solver.iterations", "solver.iterations", "solver"},
                               {"solver.iterations", "solver.iterations", "solver.iterations"},
                               {"--grab", "grabs[0]", "grabs[0]"}}};
  CHECK(origin.where("") == "f.json");
  CHECK(origin.where("title") == "f.json: title");
  CHECK(origin.where("gravity") == "--set gravity");
  CHECK(origin.where("gravity[1]") == "--set gravity: gravity[1]");
  CHECK(origin.where("gravity_other") == "f.json: gravity_other");
  CHECK(origin.where("solver.iterations") == "--set solver.iterations");
  CHECK(origin.where("solver.window") == "--set solver.iterations: solver.window");
  CHECK(origin.where("grabs[0].at") == "--grab: grabs[0].at");
  CHECK(option_of("a\nb") == "--set \"a\\nb\"");
}
