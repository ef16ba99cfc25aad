// Provenance of files: the place of the line in each format, and reading it back.
#include "base/provenance.h"

#include <catch2/catch.hpp>

using namespace fascia;

namespace {

const Provenance kMade{
    {"Software", "fascia 1"}, {"Command line", "fascia run \"a b\" --steps 3 -- x"}, {"Moment", "2 s"}};

}  // namespace

TEST_CASE("provenance is one line without the end of an XML comment, and reads back in its order") {
  const std::string json = provenance_json(kMade);
  CAPTURE(json);
  CHECK(json.find("--") == std::string::npos);
  CHECK(json.find('\n') == std::string::npos);
  CHECK(find_provenance("# fascia: " + json + "\nv 0 0 0\n") == kMade);
  CHECK(provenance_json({}) == "{}");
  CHECK(provenance_json({{"a", "b\n---"}}) == "{\"a\":\"b\\n-\\u002d-\"}");
}

TEST_CASE("each format has the line where it allows a remark") {
  const std::string line = "fascia: " + provenance_json(kMade);
  CHECK(with_provenance("v 0 0 0\n", ".obj", kMade) == "# " + line + "\nv 0 0 0\n");
  CHECK(with_provenance("<?xml version=\"1.0\"?>\n<VTKFile>\n", ".vtu", kMade) ==
        "<?xml version=\"1.0\"?>\n<!-- " + line + " -->\n<VTKFile>\n");
  CHECK(with_provenance("<VTKFile>\n", ".vtu", kMade) == "<!-- " + line + " -->\n<VTKFile>\n");
  CHECK(with_provenance("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n", ".msh", kMade) ==
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\n" + line + "\n$EndComments\n$Nodes\n");
  CHECK(with_provenance("index,x\n", ".csv", kMade) == "index,x\n");
  CHECK(with_provenance("v 0 0 0\n", ".obj", {}) == "v 0 0 0\n");
  for (const char* ending : {".obj", ".vtu", ".msh"}) {
    CAPTURE(ending);
    CHECK(find_provenance(with_provenance("\n", ending, kMade)) == kMade);
  }
  CHECK(provenance_beside("some/out.csv") == "some/out.csv.json");
}

TEST_CASE("a text without provenance, or with a damaged one, has none") {
  for (const char* text : {"", "fascia: {", "fascia: {\"a\":}", "fascia: [1]", "{\"a\":\"b\"}"}) {
    CAPTURE(text);
    CHECK(find_provenance(text).empty());
  }
  CHECK(find_provenance("fascia: {\"a\":\"b\",\"n\":3}") == Provenance{{"a", "b"}});
  CHECK(find_provenance(std::string(100000, ' ') + "fascia: {\"a\":\"b\"}").empty());  // too far from the beginning
}

TEST_CASE("a file of many times names no time") { CHECK(without_moment(kMade) == Provenance{kMade[0], kMade[1]}); }
