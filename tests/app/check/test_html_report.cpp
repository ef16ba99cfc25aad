// The HTML report: its content, and that names from files cannot become markup.
#include "app/check/html_report.h"

#include <catch2/catch.hpp>

#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("the report has a row and a section for each scene, values with their limits, and pictures in its text") {
  const TemporaryFolder folder;
  write_file(folder / "a.png", "PNG bytes");
  const std::string html =
      html_report("fascia check scenes", "2026-01-31T12:00:00",
                  {{"liver", "passed", true, 1.25, {{"mean", 0, 0.002}}, {}, "golden", folder / "a.png"},
                   {"<b>&\"x\"",
                    "FAILED",
                    false,
                    2,
                    {{"state", 0.5, 1e-5}},
                    {"differs by <0.5>"},
                    "result",
                    folder / "missing.png"}});
  CAPTURE(html);
  CHECK(count(html, "<tr><td>") == 2);
  CHECK(count(html, "<h2 ") == 2);
  CHECK(count(html, "2 scenes, 1 failed") == 1);
  CHECK(count(html, "<span>mean 0 / 0.002</span>") == 1);
  CHECK(count(html, "<span class=\"bad\">state 0.5 / 1e-05</span>") == 1);
  CHECK(count(html, "src=\"data:image/png;base64,UE5HIGJ5dGVz\"") == 1);
  CHECK(count(html, "<img ") == 1);  // the other picture does not exist
  CHECK(count(html, "<b>") == 0);
  CHECK(count(html, "&lt;b&gt;&amp;&quot;x&quot;") == 2);
  CHECK(count(html, "differs by &lt;0.5&gt;") == 1);
}
