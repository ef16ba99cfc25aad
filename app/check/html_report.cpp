#include "app/check/html_report.h"

#include <algorithm>

#include "app/check/xml_text.h"
#include "app/golden/tolerance.h"
#include "base/byte_text.h"
#include "base/file.h"

namespace fascia {
namespace {

constexpr const char* kStyle =
    "body{font:15px/1.4 sans-serif;margin:2em auto;max-width:1100px;color:#222}"
    "table{border-collapse:collapse;margin:1em 0}td,th{padding:.25em .8em;border-bottom:1px solid #ddd;text-align:left}"
    "td.n{text-align:right;font-variant-numeric:tabular-nums}.bad{color:#b00020;font-weight:bold}.good{color:#1b7a2f}"
    "img{max-width:100%;border:1px solid #ddd}pre{white-space:pre-wrap;background:#f6f6f6;padding:.6em}";

std::string anchor(std::size_t index) { return "scene-" + std::to_string(index + 1); }

std::string row(const ReportCase& c, std::size_t index) {
  std::string values;
  for (const ReportValue& v : c.values)
    values += std::string(values.empty() ? "" : ", ") + (v.measured > v.allowed ? "<span class=\"bad\">" : "<span>") +
              xml_text(v.name + " " + three_digits(v.measured) + " / " + three_digits(v.allowed)) + "</span>";
  return "<tr><td><a href=\"#" + anchor(index) + "\">" + xml_text(c.name) + "</a></td><td class=\"" +
         (c.good ? "good" : "bad") + "\">" + xml_text(c.verdict) + "</td><td>" + values + "</td><td class=\"n\">" +
         three_digits(c.seconds) + "</td></tr>\n";
}

std::string section(const ReportCase& c, std::size_t index) {
  std::string text = "<h2 id=\"" + anchor(index) + "\">" + xml_text(c.name) + ": <span class=\"" +
                     (c.good ? "good" : "bad") + "\">" + xml_text(c.verdict) + "</span></h2>\n";
  if (!c.lines.empty()) {
    text += "<pre>";
    for (const std::string& line : c.lines) text += xml_text(line) + '\n';
    text += "</pre>\n";
  }
  std::error_code none;
  if (!c.picture.empty() && std::filesystem::is_regular_file(c.picture, none))
    text += "<figure><img alt=\"" + xml_text(c.name) + "\" src=\"data:image/png;base64," +
            base64_encoded(read_file(c.picture)) + "\"><figcaption>" + xml_text(c.caption) + "</figcaption></figure>\n";
  return text;
}

}  // namespace

std::string html_report(const std::string& title, const std::string& timestamp, const std::vector<ReportCase>& cases) {
  const auto bad = std::count_if(cases.begin(), cases.end(), [](const ReportCase& c) { return !c.good; });
  std::string text = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + xml_text(title) +
                     "</title><style>" + kStyle + "</style></head><body>\n<h1>" + xml_text(title) + "</h1>\n<p>" +
                     xml_text(timestamp) + " UTC, " + std::to_string(cases.size()) +
                     (cases.size() == 1 ? " scene, " : " scenes, ") + std::to_string(bad) + " failed</p>\n" +
                     "<table><tr><th>scene</th><th>result</th><th>measured / limit</th><th>seconds</th></tr>\n";
  for (std::size_t i = 0; i < cases.size(); ++i) text += row(cases[i], i);
  text +=
      "</table>\n<p>mean: mean difference of the color channels, 0 to 1. share: share of the pixels with a channel "
      "that "
      "differs by more than 8/255. state: largest distance of a vertex from its golden, in sizes of the scene.</p>\n";
  for (std::size_t i = 0; i < cases.size(); ++i) text += section(cases[i], i);
  return text + "</body></html>\n";
}

}  // namespace fascia
