#include "app/check/junit.h"

#include <algorithm>
#include <cstdio>

#include "app/check/xml_text.h"
#include "base/number_text.h"

namespace fascia {
namespace {

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", seconds);
  return text;
}

std::string counts(const std::vector<JunitCase>& cases) {
  const auto count = [&](JunitCase::Verdict verdict) {
    return std::to_string(
        std::count_if(cases.begin(), cases.end(), [&](const JunitCase& c) { return c.verdict == verdict; }));
  };
  double seconds = 0;
  for (const JunitCase& c : cases) seconds += c.seconds;
  return " tests=\"" + std::to_string(cases.size()) + "\" failures=\"" + count(JunitCase::Verdict::failed) +
         "\" errors=\"" + count(JunitCase::Verdict::error) + "\" time=\"" + seconds_text(seconds) + "\"";
}

std::string case_xml(const std::string& suite, const JunitCase& c) {
  std::string xml = "    <testcase classname=\"" + xml_text(suite) + "\" name=\"" + xml_text(c.name) + "\" time=\"" +
                    seconds_text(c.seconds) + "\">\n";
  if (!c.properties.empty()) {
    xml += "      <properties>\n";
    for (const auto& [name, value] : c.properties)
      xml += "        <property name=\"" + xml_text(name) + "\" value=\"" + NumberText().add(value).take() + "\"/>\n";
    xml += "      </properties>\n";
  }
  if (c.verdict != JunitCase::Verdict::passed) {
    const std::string kind = c.verdict == JunitCase::Verdict::failed ? "failure" : "error";
    xml += "      <" + kind + " message=\"" + xml_text(c.message) + "\" type=\"" + kind + "\">" + xml_text(c.details) +
           "</" + kind + ">\n";
  }
  if (!c.output.empty()) xml += "      <system-out>" + xml_text(c.output) + "</system-out>\n";
  return xml + "    </testcase>\n";
}

}  // namespace

std::string junit_xml(const std::string& suite, const std::string& timestamp, const std::vector<JunitCase>& cases) {
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts(cases) +
                    ">\n  <testsuite name=\"" + xml_text(suite) + "\"" + counts(cases) + " skipped=\"0\" timestamp=\"" +
                    xml_text(timestamp) + "\">\n";
  for (const JunitCase& c : cases) xml += case_xml(suite, c);
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace fascia
