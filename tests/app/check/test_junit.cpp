// JUnit XML: its content, for any text.
// Covers: xml_text
#include "app/check/junit.h"

#include <catch2/catch.hpp>

using namespace fascia;

TEST_CASE("JUnit XML holds any text") {
  JunitCase c;
  c.name = "a<b>&\"c\"";
  c.verdict = JunitCase::Verdict::failed;
  c.message = "one\ntwo \xc3\xa9 \xff \x01";
  const std::string xml = junit_xml("s", "2026-01-31T12:00:00", {c});
  CHECK(contains(xml, "name=\"a&lt;b&gt;&amp;&quot;c&quot;\""));
  CHECK(contains(xml, "message=\"one&#10;two \xc3\xa9 ? ?\""));
  CHECK(contains(xml, "<testsuites tests=\"1\" failures=\"1\" errors=\"0\""));
}

TEST_CASE("JUnit XML has a case for each scene, with its verdict, time and output") {
  using Verdict = JunitCase::Verdict;
  const std::string xml = junit_xml("goldens", "2026-01-31T12:00:00",
                                    {{"good", Verdict::passed, 0.25, "", "", ""},
                                     {"bad", Verdict::failed, 1, "differs", "line 1\nline 2", ""},
                                     {"none", Verdict::error, 0.5, "no golden", "", "was looked for"}});
  CHECK(xml == R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites tests="3" failures="1" errors="1" time="1.750">
  <testsuite name="goldens" tests="3" failures="1" errors="1" time="1.750" skipped="0" timestamp="2026-01-31T12:00:00">
    <testcase classname="goldens" name="good" time="0.250">
    </testcase>
    <testcase classname="goldens" name="bad" time="1.000">
      <failure message="differs" type="failure">line 1&#10;line 2</failure>
    </testcase>
    <testcase classname="goldens" name="none" time="0.500">
      <error message="no golden" type="error"></error>
      <system-out>was looked for</system-out>
    </testcase>
  </testsuite>
</testsuites>
)");
}

TEST_CASE("JUnit XML has the measured and the allowed differences of a scene as properties") {
  JunitCase c;
  c.name = "liver";
  c.properties = {{"mean_measured", 0.25}, {"mean_allowed", 1e-5}};
  const std::string xml = junit_xml("s", "2026-01-31T12:00:00", {c});
  CAPTURE(xml);
  CHECK(contains(xml, R"(      <properties>
        <property name="mean_measured" value="0.25"/>
        <property name="mean_allowed" value="1e-05"/>
      </properties>
)"));
}

TEST_CASE("characters that XML forbids are replaced byte by byte, and valid UTF-8 is kept") {
  const auto name = [](const std::string& text) {
    JunitCase c;
    c.name = text;
    const std::string xml = junit_xml("s", "t", {c});
    const std::size_t begin = xml.find(" name=\"", xml.find("<testcase")) + 7;
    return xml.substr(begin, xml.find('"', begin) - begin);
  };
  for (const char* kept : {"\xc2\x80", "\xe0\xa0\x80", "\xef\xbf\xbd", "\xf0\x9f\x98\x80", "\xf4\x8f\xbf\xbf"}) {
    CAPTURE(kept);
    CHECK(name(kept) == kept);
  }
  CHECK(name("a\tb") == "a&#9;b");
  CHECK(name("a\rb") == "a?b");
  CHECK(name("\xc0\xaf") == "??");            // overlong encoding
  CHECK(name("\xe0\x80\x80") == "???");       // likewise
  CHECK(name("\xed\xa0\x80") == "???");       // half of a surrogate pair
  CHECK(name("\xef\xbf\xbe") == "???");       // not a character
  CHECK(name("\xf4\x90\x80\x80") == "????");  // beyond the last character
  CHECK(name("\xe2\x82") == "??");            // truncated
}
