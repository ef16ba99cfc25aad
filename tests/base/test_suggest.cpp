#include <catch2/catch.hpp>

#include "base/suggest.h"

using namespace fascia;

TEST_CASE("edit distance") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("abc", "") == 3);
  CHECK(edit_distance("gravity", "gravity") == 0);
  CHECK(edit_distance("gravty", "gravity") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("ab", "ba") == 2);
}

TEST_CASE("the nearest word, unless more than half of it differs") {
  const std::vector<std::string> words = {"iterations", "substeps", "tolerance", "box"};
  CHECK(nearest("iteration", words) == "iterations");
  CHECK(nearest("iters", words) == "iterations");  // 5 of 10
  CHECK(nearest("iter", words).empty());           // 6 of 10
  CHECK(nearest("bix", words) == "box");
  CHECK(nearest("E", words).empty());
  CHECK(nearest("", words).empty());
  CHECK(nearest("a", {}).empty());
  CHECK(nearest("ab", {"ax", "ay"}) == "ax");
  CHECK(nearest(std::string(65, 'x'), {std::string(65, 'x')}).empty());
  CHECK(perhaps("substep", words) == ", perhaps \"substeps\"");
  CHECK(perhaps("xyz", words).empty());
}

TEST_CASE("case, underscores, hyphens and blanks are ignored") {
  const std::vector<std::string> words = {"von_mises", "volume_ratio", "none", "solver.method", "--data-dir"};
  for (const char* word :
       {"vonmises", "von mises", "Von-Mises", "VONMISES", "von__mises", "v o n m i s e s", "VonMisses"}) {
    CAPTURE(word);
    CHECK(nearest(word, words) == "von_mises");
  }
  CHECK(nearest("--DataDir", words) == "--data-dir");
  CHECK(nearest("NONE", words) == "none");
  CHECK(nearest("___", words).empty());
  CHECK(nearest("stress", words).empty());
  CHECK(nearest("left", {"Left", "left"}) == "left");  // the exact spelling is preferred
  CHECK(nearest("Left", {"left", "Left"}) == "Left");
}

TEST_CASE("a list names at most twenty words") {
  CHECK(join({}).empty());
  CHECK(join({"a", "b"}) == "a, b");
  CHECK(join(std::vector<std::string>(27, "a")) ==
        "a, a, a, a, a, a, a, a, a, a, a, a, a, a, a, a, a, a, a, a, a, a, a, a and 3 more");
}
